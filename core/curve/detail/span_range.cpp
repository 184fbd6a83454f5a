#include "core/curve/detail/span_range.h"

#include <algorithm>
#include <cassert>

#include "core/curve/detail/trusted.h"

namespace batten::core {

Curve curve_over_spans(const Curve& curve, std::size_t first, std::size_t last) {
    const auto p = static_cast<std::size_t>(curve.degree());
    assert(p <= first && first <= last && last + p + 1 < curve.knots().size());
    const auto values = curve.knots().values().subspan(first - p, last - first + 2 * p + 2);
    const std::size_t n = curve.control_points().size();
    std::vector<Point> points;
    std::vector<double> weights;
    for (std::size_t i = first - p; i <= last; ++i) {
        points.push_back(curve.control_points()[i % n]);
        weights.push_back(curve.weights()[i % n]);
    }
    const bool is_rational = std::ranges::any_of(weights, [&](double w) { return w != weights.front(); });
    return Trusted::curve(
        Trusted::knots(curve.degree(), false, KnotKind::custom, std::vector<double>(values.begin(), values.end())),
        std::move(points), std::move(weights), is_rational);
}

}  // namespace batten::core
