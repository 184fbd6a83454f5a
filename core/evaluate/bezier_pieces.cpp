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

BezierPiece BezierPieces::operator[](std::size_t k) const {
    BezierPiece piece{.interval = interval(k), .span = span(k), .points = {}};
    piece.points.reserve(order());
    for (std::size_t j = 0; j < order(); ++j)
        piece.points.push_back(lift(points(k)[j], weights_ ? weights(k)[j] : common_weight_));
    return piece;
}

namespace {

// Hands the points of the pieces over, from the last piece to the first: `write` gets a point and where it stands.
template <class P, class Load, class Write>
void write_pieces(const KnotVector& knots, std::span<std::size_t> spans, Load load, Write write) {
    with_known_degree(static_cast<std::size_t>(knots.degree()), [&](auto p) {
        Decomposition<P, decltype(p), Load> pieces(p, knots.values(), spans.back(), load);
        for (std::size_t k = spans.size(); k-- > 0;) {
            spans[k] = pieces.span();
            pieces.emit(k == 0, [&](const auto& piece, std::size_t) {
                for (std::size_t j = 0; j <= p; ++j) write(k * (p + 1) + j, piece[j]);
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
    NewArray<Point> points(count * (p + 1));
    if (count == 0) return {knots, SharedArray(std::move(spans)), SharedArray(std::move(points))};
    while (knots[last] == knots[last + 1]) --last;
    spans.values().back() = last;
    const auto control = curve.control_points();
    const std::size_t n = control.size();
    const auto index = [n](std::size_t i) { return i < n ? i : i % n; };
    if (!curve.is_rational()) {
        const auto load = [&](std::size_t i) { return control[index(i)]; };
        write_pieces<Point>(knots, spans.values(), load,
                            [to = points.data()](std::size_t i, Point point) { to[i] = point; });
        BezierPieces pieces(knots, SharedArray(std::move(spans)), SharedArray(std::move(points)));
        pieces.common_weight_ = curve.weights().front();
        return pieces;
    }
    NewArray<double> weights(points.size());
    const auto load = [&](std::size_t i) { return WeightedPoint{control[index(i)], curve.weights()[index(i)]}; };
    const auto write = [to = points.data(), to_weight = weights.data()](std::size_t i, const WeightedPoint& point) {
        to[i] = point.point;
        to_weight[i] = point.weight;
    };
    write_pieces<WeightedPoint>(knots, spans.values(), load, write);
    BezierPieces pieces(knots, SharedArray(std::move(spans)), SharedArray(std::move(points)));
    pieces.weights_ = SharedArray(std::move(weights));
    return pieces;
}

BezierPieces bezier_pieces(const Curve& curve) {
    const auto p = static_cast<std::size_t>(curve.degree());
    return bezier_pieces(curve, p, curve.knots().size() - p - 2);
}

}  // namespace batten::core
