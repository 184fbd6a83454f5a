#include "core/evaluate/detail/precise_jet.h"

namespace batten::core {

namespace {

using Points = LocalPoints<PreciseHomogeneousPoint>;

Points precise_local_points(const Curve& curve, const SpanKnots& at, Point origin) {
    Points points;
    const std::size_t n = curve.control_points().size();
    for (std::size_t j = 0; j <= at.p; ++j) {
        const std::size_t i = (at.s - at.p + j) % n;
        points[j] = lift_precisely(curve.control_points()[i], curve.weights()[i], origin);
    }
    return points;
}

// As in bspline.h, with shares that are not rounded.
void differentiate_precisely(Points& points, const SpanKnots& at, std::size_t r) {
    const auto factor = static_cast<double>(at.p - r + 1);
    for (std::size_t j = at.p; j >= r; --j)
        points[j] = (factor / exact_sum(at.upper(j, r), -at.lower(j))) * (points[j] - points[j - 1]);
}

PreciseHomogeneousPoint blended_precisely(Points points, const SpanKnots& at, double u, std::size_t levels_done) {
    for (std::size_t r = levels_done + 1; r <= at.p; ++r)
        for (std::size_t j = at.p; j >= r; --j)
            points[j] = blend_precisely(points[j - 1], points[j], at.lower(j), at.upper(j, r), u);
    return points[at.p];
}

}  // namespace

PreciseHomogeneousPoint precise_point(const Curve& curve, const SpanKnots& at, double u, Point origin) {
    return blended_precisely(precise_local_points(curve, at, origin), at, u, 0);
}

std::array<PreciseHomogeneousPoint, 3> precise_jet(const Curve& curve, const SpanKnots& at, double u, Point origin) {
    std::array<PreciseHomogeneousPoint, 3> jet;
    Points points = precise_local_points(curve, at, origin);
    for (std::size_t k = 0; k <= std::min<std::size_t>(2, at.p); ++k) {
        if (k > 0) differentiate_precisely(points, at, k);
        jet[k] = blended_precisely(points, at, u, k);
    }
    return jet;
}

}  // namespace batten::core
