#include "core/make/detail/directed.h"

#include <algorithm>
#include <utility>

namespace batten::core {

bool is_canonical(std::span<const Point> points) {
    const auto less = [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
    return !std::lexicographical_compare(points.rbegin(), points.rend(), points.begin(), points.end(), less);
}

Curve reversed(const Curve& curve) {
    const auto p = static_cast<std::size_t>(curve.degree());
    CurveDefinition definition = curve.definition();
    for (double& knot : definition.knots) knot = 1.0 - knot;
    std::reverse(definition.knots.begin(), definition.knots.end());
    std::reverse(definition.points.begin(), definition.points.end());
    // Control point i of the reversed period is the old p-1-i.
    const std::size_t n = definition.points.size();
    if (curve.is_periodic())
        std::rotate(definition.points.begin(), definition.points.begin() + static_cast<std::ptrdiff_t>((n - p % n) % n),
                    definition.points.end());
    return Curve::make(std::move(definition)).value();
}

}  // namespace batten::core
