#include "core/measure/detail/onward_pieces.h"

#include "core/base/detail/unit_interval.h"
#include "core/curve/control_box.h"
#include "core/evaluate/detail/subdivide.h"
#include "core/measure/detail/contact_piece.h"
#include "core/measure/detail/piece_forms.h"

namespace batten::core {

namespace {

bool may_turn_back(const BezierPiece& piece) {
    return !ContactPiece(0, {0.0, 1.0}, piece.points).directions;
}

void append_cut(std::vector<BezierPiece>& pieces, BezierPiece piece, const PieceForms& forms) {
    for (const SignRun& run : sign_runs(forms.forms, speed_squared)) {
        const double u = from_unit(forms.interval, run.where.lower);
        const bool is_inside = piece.interval.lower < u && u < piece.interval.upper;
        if (run.sign != 0 || run.where.length() > 0.0 || !is_inside) continue;
        auto [before, after] = cut_piece(piece, u);
        pieces.push_back(std::move(before));
        piece = std::move(after);
    }
    pieces.push_back(std::move(piece));
}

}  // namespace

std::vector<BezierPiece> onward_pieces(const Curve& curve, Point origin) {
    const BezierPieces found = bezier_pieces(seen_from(curve, origin));
    std::vector<BezierPiece> whole(found.begin(), found.end());
    if (std::none_of(whole.begin(), whole.end(), may_turn_back)) return whole;
    const std::vector<PieceForms> forms = piece_forms(curve, 1);
    std::vector<BezierPiece> pieces;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (may_turn_back(whole[i]))
            append_cut(pieces, std::move(whole[i]), forms[i]);
        else
            pieces.push_back(std::move(whole[i]));
    }
    return pieces;
}

}  // namespace batten::core
