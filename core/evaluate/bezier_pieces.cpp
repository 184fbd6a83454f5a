#include "core/evaluate/bezier_pieces.h"

#include <cassert>

#include "core/curve/detail/known_degree.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/blossom.h"
#include "core/evaluate/detail/decomposition.h"

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

namespace {

// Fills `points` with what `lifted` makes of those of the pieces, from the last piece to the first.
template <class P, class Load, class Lifted>
void fill_pieces(const KnotVector& knots, std::span<std::size_t> spans, std::span<HomogeneousPoint> points, Load load,
                 Lifted lifted) {
    with_known_degree(static_cast<std::size_t>(knots.degree()), [&](auto p) {
        Decomposition<P, decltype(p), Load> pieces(p, knots.values(), spans.back(), load);
        for (std::size_t k = spans.size(); k-- > 0;) {
            spans[k] = pieces.span();
            pieces.emit(k == 0, [&, place = &points[k * (p + 1)]](const auto& piece, std::size_t) {
                for (std::size_t j = 0; j <= p; ++j) place[j] = lifted(piece[j]);
            });
        }
    });
}

}  // namespace

BezierPieces bezier_pieces(const Curve& curve, std::size_t first, std::size_t last) {
    const KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(knots.degree());
    assert(p <= first && last + p + 1 < knots.size());
    std::size_t count = 0;
    for (std::size_t s = first; s <= last; ++s)
        if (knots[s] < knots[s + 1]) ++count;
    NewArray<std::size_t> spans(count);
    NewArray<HomogeneousPoint> points(count * (p + 1));
    if (count == 0) return {knots, SharedArray(std::move(spans)), SharedArray(std::move(points))};
    while (knots[last] == knots[last + 1]) --last;
    spans.values().back() = last;
    const auto control = curve.control_points();
    const std::size_t n = control.size();
    const auto index = [n](std::size_t i) { return i < n ? i : i % n; };
    if (curve.is_rational()) {
        const auto load = [&](std::size_t i) { return WeightedPoint{control[index(i)], curve.weights()[index(i)]}; };
        const auto lifted = [](const WeightedPoint& point) { return lift(point.point, point.weight); };
        fill_pieces<WeightedPoint>(knots, spans.values(), points.values(), load, lifted);
    } else {
        const auto load = [&](std::size_t i) { return control[index(i)]; };
        const auto lifted = [weight = curve.weights().front()](Point point) { return lift(point, weight); };
        fill_pieces<Point>(knots, spans.values(), points.values(), load, lifted);
    }
    return {knots, SharedArray(std::move(spans)), SharedArray(std::move(points))};
}

BezierPieces bezier_pieces(const Curve& curve) {
    const auto p = static_cast<std::size_t>(curve.degree());
    return bezier_pieces(curve, p, curve.knots().size() - p - 2);
}

}  // namespace batten::core
