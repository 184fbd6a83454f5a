#include "core/evaluate/bezier_pieces.h"

#include <algorithm>
#include <cassert>

#include "core/curve/detail/spline.h"
#include "core/evaluate/blossom.h"

namespace batten::core {

BezierPiece bezier_piece(const Curve& curve, std::size_t span) {
    const auto p = static_cast<std::size_t>(curve.degree());
    assert(p <= span && span + p + 1 < curve.knots().size() && curve.knots()[span] < curve.knots()[span + 1]);
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
    Spline<HomogeneousPoint> spline{.p = p, .knots = {knots.values().begin(), knots.values().end()}};
    for (std::size_t i = 0; i + p + 1 < knots.size(); ++i) spline.points.push_back(curve.homogeneous_point(i));
    insert_ascending<HomogeneousPoint>(spline, knots_missing_for_pieces(spline));
    std::vector<BezierPiece> pieces;
    std::size_t last = spline.last_of_run(spline.domain().lower);
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s) {
        if (knots[s] == knots[s + 1]) continue;
        while (spline.knots[last + 1] <= knots[s]) ++last;
        const auto points = std::span(spline.points).subspan(last - p, p + 1);
        pieces.push_back({{knots[s], knots[s + 1]}, s, {points.begin(), points.end()}});
    }
    return pieces;
}

}  // namespace batten::core
