#include "core/evaluate/farin_points.h"

#include <cassert>

#include "core/curve/detail/near_share.h"

namespace batten::core {

namespace {

struct Leg {
    std::size_t from;
    std::size_t to;
};

Leg leg_of(const Curve& curve, std::size_t leg) {
    assert(leg < leg_count(curve));
    return {leg, (leg + 1) % curve.control_points().size()};
}

}  // namespace

std::size_t leg_count(const Curve& curve) {
    return curve.control_points().size() - (curve.is_periodic() ? 0U : 1U);
}

FarinPoint farin_point(const Curve& curve, std::size_t leg) {
    const auto [from, to] = leg_of(curve, leg);
    const WeightedPoint a{curve.control_points()[from], curve.weights()[from]};
    const WeightedPoint b{curve.control_points()[to], curve.weights()[to]};
    const double share = 1.0 / (1.0 + a.weight / b.weight);
    const Point point = combined(a, b, 0.5).point;
    if (is_finite(point)) return {point, share};
    // The leg is longer than a double.
    return {tip_of((1.0 - share) * vector_to(a.point) + share * vector_to(b.point)), share};
}

std::optional<double> nearest_farin_share(const Curve& curve, std::size_t leg, Point position) {
    const auto [from, to] = leg_of(curve, leg);
    const Point start = curve.control_points()[from];
    const Vector along = curve.control_points()[to] - start;
    const double size = robust_length(along);
    if (!(size > 0.0)) return std::nullopt;
    // By the direction, because the square of a length need not be a double.
    return farin_shares.clamp(dot((position - start) / size, along / size));
}

}  // namespace batten::core
