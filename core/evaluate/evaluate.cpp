#include "core/evaluate/evaluate.h"

#include <cassert>
#include <cmath>

#include "core/base/detail/binomial.h"
#include "core/curve/detail/bspline.h"
#include "core/evaluate/detail/precise_jet.h"

namespace batten::core {

namespace {

using HomogeneousJet = std::vector<HomogeneousPoint>;  // a homogeneous point and its derivatives

// A curve slower than this part of its polygon has lost digits that its curvature needs.
constexpr double slow_part = 0.25;

// The control point that C(u) is when p knots equal u: C(u) = b(u, ..., u), and that is control point i where u_{i+1},
// ..., u_{i+p} all equal u. Taken as it stands it keeps every bit, which lifting and projecting would not.
std::optional<std::size_t> control_point_at(const SpanKnots& at, double u) {
    if (at.knots[at.s - at.p + 1] == u) return at.s - at.p;
    if (at.knots[at.s + at.p] == u) return at.s;
    return std::nullopt;
}

// Twice: the second time seen from the first answer, where the coordinates are small, and so is what rounding does to
// them. What is left is little more than the last rounding.
Point point_on_span(const Curve& curve, const SpanKnots& at, double u) {
    if (const auto i = control_point_at(at, u)) return curve.control_points()[*i % curve.control_points().size()];
    const Point nearly = project(de_boor(local_shadow_points(curve, at), at, u));
    return nearly + vector_to(project(de_boor(local_shadow_points(curve, at, nearly), at, u)));
}

// A(u), A'(u), ... of the homogeneous spline; from order p+1 on they are zero.
HomogeneousJet homogeneous_derivatives(LocalPoints<HomogeneousPoint> points, const SpanKnots& at, double u,
                                       std::size_t order) {
    HomogeneousJet derivatives(order + 1, HomogeneousPoint(0.0));
    for (std::size_t k = 0; k <= std::min(order, at.p); ++k) {
        if (k > 0) differentiate_level(points, at, k);
        derivatives[k] = de_boor(points, at, u, k);
    }
    return derivatives;
}

// The jet at `point` of the shadow of what is seen from there, by Leibniz's rule for A = w C:
//     C^(k) = (A^(k) - sum_{i=1..k} binomial(k, i) w^(i) C^(k-i)) / w
Jet shadow_jet(const HomogeneousJet& homogeneous, Point point) {
    const double weight = homogeneous[0].z;
    // Nothing but for rounding.
    const Vector from_point = plane_part(homogeneous[0]) / weight;
    Jet jet{.point = point};
    jet.derivatives.reserve(homogeneous.size() - 1);
    for (std::size_t k = 1; k < homogeneous.size(); ++k) {
        Vector sum = plane_part(homogeneous[k]);
        double binomial = 1.0;
        for (std::size_t i = 1; i <= k; ++i) {
            binomial = next_binomial(binomial, k, i);
            sum -= binomial * homogeneous[i].z * (i < k ? jet[k - i] : from_point);
        }
        jet.derivatives.push_back(sum / weight);
    }
    return jet;
}

// The largest speed that the legs of the local polygon would give at this weight. Rounding leaves an error of a few
// units in its last place in every speed computed from them, so that a speed below is as good as none.
double polygon_speed(LocalPoints<HomogeneousPoint> points, const SpanKnots& at, double weight) {
    differentiate_level(points, at, 1);
    double largest = 0.0;
    for (std::size_t j = 1; j <= at.p; ++j) largest = std::max(largest, robust_length(plane_part(points[j])));
    return largest / weight;
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

}  // namespace

Point point_at(const Curve& curve, double u, Side side) {
    const auto [inside, at] = located(curve.knots(), u, side);
    return point_on_span(curve, at, inside);
}

Jet derivatives_at(const Curve& curve, double u, int order, Side side) {
    assert(order >= 0);
    const auto [inside, at] = located(curve.knots(), u, side);
    const Point point = point_on_span(curve, at, inside);
    const auto points = local_shadow_points(curve, at, point);
    return shadow_jet(homogeneous_derivatives(points, at, inside, static_cast<std::size_t>(order)), point);
}

std::optional<double> curvature_at(const Curve& curve, double u, Side side) {
    const auto [inside, at] = located(curve.knots(), u, side);
    const Point point = point_on_span(curve, at, inside);
    const auto points = local_shadow_points(curve, at, point);
    const HomogeneousJet homogeneous = homogeneous_derivatives(points, at, inside, 2);
    const Jet jet = shadow_jet(homogeneous, point);
    const double speed = robust_length(jet[1]);
    const double resolution = 64 * std::numeric_limits<double>::epsilon();
    const double fast = polygon_speed(points, at, homogeneous[0].z);
    if (!(speed > resolution * fast)) return std::nullopt;
    const Vector tangent = jet[1] / speed;
    // Where the curve is slow its speed is what differences of large vectors leave.
    const double curvature =
        speed < slow_part * fast ? precise_curvature(curve, at, inside, point) : cross(tangent, jet[2]) / speed / speed;
    return std::isfinite(curvature) ? std::optional(curvature) : std::nullopt;
}

}  // namespace batten::core
