#include "core/bezier_pieces.h"

#include <algorithm>

#include "core/blossom.h"

namespace batten::core {

BezierPiece bezier_piece(const Curve& curve, std::size_t span) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const Interval interval{curve.knots()[span], curve.knots()[span + 1]};
    BezierPiece piece{.interval = interval, .span = span, .points = {}};
    piece.points.reserve(p + 1);
    std::vector<double> arguments(p, interval.lower);
    piece.points.push_back(blossom(curve, span, arguments));
    for (double& argument : arguments) {
        argument = interval.upper;
        piece.points.push_back(blossom(curve, span, arguments));
    }
    return piece;
}

std::vector<BezierPiece> bezier_pieces(const Curve& curve) {
    const KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(knots.degree());
    std::vector<BezierPiece> pieces;
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s)
        if (knots[s] < knots[s + 1]) pieces.push_back(bezier_piece(curve, s));
    return pieces;
}

}  // namespace batten::core
