#include "core/refine/detail/low_elevation.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/base/detail/are_finite.h"
#include "core/curve/detail/trusted.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/detail/decomposition.h"
#include "core/refine/detail/curve_arrays.h"

namespace batten::core {

namespace {

constexpr std::size_t highest_low_degree = 3;

Point mean_around(Point before, Point middle, Point after) {
    return middle + 0.25 * ((before - middle) + (after - middle));
}

WeightedPoint mean_around(const WeightedPoint& before, const WeightedPoint& middle, const WeightedPoint& after) {
    const double weight = middle.weight + 0.25 * ((before.weight - middle.weight) + (after.weight - middle.weight));
    return {middle.point + 0.25 * (before.weight / weight * (before.point - middle.point) +
                                   after.weight / weight * (after.point - middle.point)),
            weight};
}

// Point k of the piece in degree p+1, 0 <= k <= p+1.
template <std::size_t p, class P>
P elevated_point(const std::array<P, p + 1>& piece, std::size_t k) {
    if (k == 0) return piece[0];
    if (k == p + 1) return piece[p];
    const double share = static_cast<double>(std::min(k, p + 1 - k)) / static_cast<double>(p + 1);
    return 2 * k <= p + 1 ? combined(piece[k], piece[k - 1], share) : combined(piece[k - 1], piece[k], share);
}

// Hands out the new control points from the last to the first. `load(i)` gives the old ones.
template <std::size_t p, class P, class Load, class Put>
void elevate_pieces(std::span<const double> knots, Load load, Put put) {
    using Degree = std::integral_constant<std::size_t, p>;
    std::size_t s = knots.size() - p - 2;
    Decomposition<P, Degree, Load> pieces(Degree(), knots, s, load);
    std::size_t multiplicity = p + 1;  // of the knot on the right
    P after = load(s);                 // the Bézier point behind that knot
    for (bool is_first = false; !is_first;) {
        is_first = knots[s] == knots.front();
        pieces.emit(is_first, [&](const std::array<P, p + 1>& piece, std::size_t left_multiplicity) {
            if (p == 3 && multiplicity == 1) put(mean_around(piece[p - 1], load(s - 1), after));
            // The point at a knot of multiplicity p belongs to the span behind it.
            const std::size_t last = multiplicity == p ? p : std::min(multiplicity, p) + 1;
            const std::size_t first = left_multiplicity < p ? p - left_multiplicity : 0;
            for (std::size_t k = last + 1; k-- > first;) put(elevated_point<p>(piece, k));
            after = piece[1];
            multiplicity = left_multiplicity;
        });
        s -= multiplicity;
    }
}

template <class P, class Load, class Put>
void elevate_pieces(const KnotVector& knots, Load load, Put put) {
    if (knots.degree() == 1)
        elevate_pieces<1, P>(knots.values(), load, put);
    else if (knots.degree() == 2)
        elevate_pieces<2, P>(knots.values(), load, put);
    else
        elevate_pieces<3, P>(knots.values(), load, put);
}

// Every run of equal knots with one knot more.
NewArray<double> longer_knots(std::span<const double> knots, std::size_t runs) {
    NewArray<double> longer(knots.size() + runs);
    double* place = longer.data();
    for (std::size_t i = 0; i < knots.size(); ++i) {
        *place++ = knots[i];
        if (i + 1 == knots.size() || knots[i + 1] != knots[i]) *place++ = knots[i];
    }
    return longer;
}

}  // namespace

bool has_low_elevation(const Curve& curve) {
    return static_cast<std::size_t>(curve.degree()) <= highest_low_degree && is_clamped(curve.knots());
}

Result<Curve> low_elevation(const Curve& curve) {
    assert(has_low_elevation(curve));
    const KnotVector& knots = curve.knots();
    NewArray<double> longer = longer_knots(knots.values(), segment_count(knots) + 1);
    const std::size_t count = longer.size() - static_cast<std::size_t>(curve.degree()) - 2;
    NewArray<Point> points(count);
    NewArray<double> weights(count);
    Point* place = points.data() + count;
    if (curve.is_rational()) {
        double* weight_place = weights.data() + count;
        elevate_pieces<WeightedPoint>(
            knots,
            [&](std::size_t i) {
                return WeightedPoint{curve.control_points()[i], curve.weights()[i]};
            },
            [&](const WeightedPoint& point) {
                *--place = point.point;
                *--weight_place = point.weight;
            });
    } else {
        elevate_pieces<Point>(
            knots, [old = curve.control_points()](std::size_t i) { return old[i]; },
            [&](const Point& point) { *--place = point; });
        std::fill_n(weights.data(), count, curve.weights().front());
    }
    assert(place == points.data());
    if (!are_finite(points.values())) return refuse({.code = CurveErrorCode::not_computable});
    const bool is_rational = curve.is_rational() && !are_equal(weights.values());
    return Trusted::curve(
        Trusted::knots_of_kind_or_custom(curve.degree() + 1, false, knots.kind(), SharedArray(std::move(longer))),
        SharedArray(std::move(points)), SharedArray(std::move(weights)), is_rational);
}

}  // namespace batten::core
