#include "core/evaluate/evaluate.h"

#include <cassert>
#include <cmath>

#include "core/evaluate/detail/homogeneous_jet.h"
#include "core/evaluate/detail/precise_jet.h"
#include "core/evaluate/detail/span_curve.h"

namespace batten::core {

namespace {

// A curve slower than this part of its polygon has lost digits that its curvature needs.
constexpr double slow_part = 0.25;

// The control point that C(u) is when p knots equal u: C(u) = b(u, ..., u), and that is control point i where u_{i+1},
// ..., u_{i+p} all equal u. Taken as it stands it keeps every bit, which lifting and projecting would not.
std::optional<std::size_t> control_point_at(const SpanKnots& at, double u) {
    if (at.knots[at.s - at.p + 1] == u) return at.s - at.p;
    if (at.knots[at.s + at.p] == u) return at.s;
    return std::nullopt;
}

template <class Degree>
Point point_on_span(const SpanCurve<Degree>& span, const Curve& curve, const SpanKnots& at, double u) {
    if (const auto i = control_point_at(at, u)) return curve.control_points()[*i % curve.control_points().size()];
    return span.point();
}

template <class Degree>
Jet rational_jet(const SpanCurve<Degree>& span, Point point, std::size_t order) {
    // Nothing but for rounding.
    HomogeneousJet seen{.point = span.weighted(point), .weight = span.weight()};
    span.while_derivative(point, order, [&](std::size_t, Vector derivative, double weight, const auto&...) {
        seen.derivatives.push_back(derivative);
        seen.weights.push_back(weight);
        return true;
    });
    return {point, shadow_derivatives(seen, order)};
}

template <class Degree>
Jet jet_on_span(const SpanCurve<Degree>& span, Point point, std::size_t order) {
    if (span.is_rational()) return rational_jet(span, point, order);
    Jet jet{.point = point};
    span.while_derivative(point, order, [&](std::size_t, Vector derivative, const auto&...) {
        jet.derivatives.push_back(derivative);
        return true;
    });
    while (jet.derivatives.size() < order) jet.derivatives.push_back(Vector(0.0, 0.0));
    return jet;
}

// The largest speed that the legs of the local polygon would give at this weight. Rounding leaves an error of a few
// units in its last place in every speed computed from them, so that a speed below is as good as none.
template <class Degree>
double polygon_speed(const SpanCurve<Degree>& span, Point point, Degree p) {
    double largest = 0.0;
    span.while_derivative(point, 1, [&](std::size_t, Vector, double, const auto& legs, const auto&) {
        for (std::size_t j = 1; j <= p; ++j) largest = std::max(largest, robust_length(std::bit_cast<Vector>(legs[j])));
        return true;
    });
    return largest / span.weight();
}

// det(A, A', A'') w^3 / |(x' w - x w', y' w - y w')|^3 for A = (x, y, w), which is det(C', C'') / |C'|^3.
double precise_curvature(const Curve& curve, const SpanKnots& at, double u, Point origin) {
    const auto [a, d, dd] = precise_jet(curve, at, u, origin);
    const auto minor = [](DoubleDouble i, DoubleDouble j, DoubleDouble k, DoubleDouble l) { return i * l - j * k; };
    const double determinant =
        (a.x * minor(d.y, d.w, dd.y, dd.w) - a.y * minor(d.x, d.w, dd.x, dd.w) + a.w * minor(d.x, d.y, dd.x, dd.y))
            .rounded();
    const double speed = std::hypot(minor(a.w, d.w, a.x, d.x).rounded(), minor(a.w, d.w, a.y, d.y).rounded());
    const double slowness = a.w.rounded() / speed;
    return determinant * slowness * slowness * slowness;
}

template <class Degree>
[[gnu::flatten]] Point point_of_degree(const Curve& curve, const SpanKnots& at, Degree p, double u) {
    return point_on_span(SpanCurve(curve, at, p, u), curve, at, u);
}

template <class Degree>
[[gnu::flatten]] Jet jet_of_degree(const Curve& curve, const SpanKnots& at, Degree p, double u, std::size_t order) {
    const SpanCurve span(curve, at, p, u);
    return jet_on_span(span, point_on_span(span, curve, at, u), order);
}

template <class Degree>
std::optional<double> curvature_of_degree(const Curve& curve, const SpanKnots& at, Degree p, double u) {
    const SpanCurve span(curve, at, p, u);
    const Point point = point_on_span(span, curve, at, u);
    const Jet jet = jet_on_span(span, point, 2);
    const double speed = robust_length(jet[1]);
    const double resolution = 64 * std::numeric_limits<double>::epsilon();
    const double fast = polygon_speed(span, point, p);
    if (!(speed > resolution * fast)) return std::nullopt;
    const Vector tangent = jet[1] / speed;
    // Where the curve is slow its speed is what differences of large vectors leave.
    const double curvature =
        speed < slow_part * fast ? precise_curvature(curve, at, u, point) : cross(tangent, jet[2]) / speed / speed;
    return std::isfinite(curvature) ? std::optional(curvature) : std::nullopt;
}

}  // namespace

Point point_at(const Curve& curve, double u, Side side) {
    const auto [inside, at] = located(curve.knots(), u, side);
    return with_known_degree<10>(at.p,
                                 [&curve, u = inside, &at = at](auto p) { return point_of_degree(curve, at, p, u); });
}

Jet derivatives_at(const Curve& curve, double u, int order, Side side) {
    assert(order >= 0);
    const auto [inside, at] = located(curve.knots(), u, side);
    return with_known_degree(at.p, [&curve, u = inside, &at = at, order](auto p) {
        return jet_of_degree(curve, at, p, u, static_cast<std::size_t>(order));
    });
}

std::optional<double> curvature_at(const Curve& curve, double u, Side side) {
    const auto [inside, at] = located(curve.knots(), u, side);
    return with_known_degree(at.p,
                             [&curve, u = inside, &at = at](auto p) { return curvature_of_degree(curve, at, p, u); });
}

}  // namespace batten::core
