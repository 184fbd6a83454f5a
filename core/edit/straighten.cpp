#include "core/edit/straighten.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/curve/detail/edit_checks.h"

namespace batten::core {

Result<Curve> straighten(const Curve& curve, std::size_t first, std::size_t last) {
    const std::size_t n = curve.control_points().size();
    const auto p = static_cast<std::size_t>(curve.degree());
    const auto check = check_point_index(first, n - 1).and_then([&] { return check_point_index(last, n - 1); });
    if (!check) return refuse(check.error());
    if (!curve.is_periodic() && last < first) std::swap(first, last);
    const std::size_t steps = (last + n - first) % n;
    if (steps < p)
        return refuse({.code = CurveErrorCode::too_few_points,
                       .value = static_cast<double>(steps + 1),
                       .lower = static_cast<double>(p + 1)});
    CurveDefinition definition = curve.definition();
    const Point start = definition.points[first];
    const Vector line = definition.points[last] - start;
    const double length = std::max(std::abs(line.x), std::abs(line.y));
    if (!(length > 0.0))
        return refuse({.code = CurveErrorCode::points_coincide, .index = last, .value = static_cast<double>(first)});
    // Of a size that can be squared.
    const Vector direction = line / length;
    const double square = dot(direction, direction);
    for (std::size_t k = 1; k < steps; ++k) {
        Point& point = definition.points[(first + k) % n];
        point = start + dot(point - start, direction) / square * direction;
    }
    return Curve::make(std::move(definition));
}

}  // namespace batten::core
