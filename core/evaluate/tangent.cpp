#include "core/evaluate/tangent.h"

#include <cmath>

#include "core/curve/detail/bspline.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

constexpr double resolution = 256 * std::numeric_limits<double>::epsilon();

double size_of(const HomogeneousPoint& point) {
    return robust_length(plane_part(point));
}

// The largest of the points that remain after `levels_done` levels.
double largest_of(const LocalPoints<HomogeneousPoint>& points, const SpanKnots& at, std::size_t levels_done) {
    double largest = 0.0;
    for (std::size_t j = levels_done; j <= at.p; ++j) largest = std::max(largest, size_of(points[j]));
    return largest;
}

}  // namespace

std::optional<Vector> tangent_at(const Curve& curve, double u, Side side) {
    const auto [inside, at] = located(curve.knots(), u, side);
    // The side that is really looked from: at the ends of the domain the one inside.
    const bool is_from_left = side == Side::left ? at.knots[at.s] < inside : at.knots[at.s + 1] == inside;
    auto points = local_shadow_points(curve, at, point_at(curve, inside, side));
    for (std::size_t k = 1; k <= at.p; ++k) {
        differentiate_level(points, at, k);
        // Seen from C(u) the homogeneous point is (0, 0, w), so the first derivative of A that does not vanish is w
        // times that of C, but for its third coordinate, which does not matter.
        const HomogeneousPoint derivative = de_boor(points, at, inside, k);
        const double size = size_of(derivative);
        if (!(size > resolution * largest_of(points, at, k)) || !std::isfinite(size)) continue;
        const Vector direction = plane_part(derivative) / size;
        return is_from_left && k % 2 == 0 ? -direction : direction;
    }
    return std::nullopt;
}

}  // namespace batten::core
