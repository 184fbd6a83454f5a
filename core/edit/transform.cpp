#include "core/edit/transform.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "core/curve/detail/edit_checks.h"
#include "core/curve/detail/trusted.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

// Of the control points `indices`, each once; of a map and its negative, which are one, that with positive factors.
Result<std::vector<double>> mapped_weights(const Curve& curve, std::span<const std::size_t> indices,
                                           const PlaneMap& map) {
    std::vector<double> weights(curve.weights().begin(), curve.weights().end());
    const bool is_negative = std::ranges::all_of(
        indices, [&](std::size_t i) { return weight_factor(map, curve.control_points()[i]) < 0.0; });
    for (const std::size_t i : indices) {
        const double factor = (is_negative ? -1.0 : 1.0) * weight_factor(map, curve.control_points()[i]);
        weights[i] = factor * curve.weights()[i];
        if (!(factor > 0.0))
            return refuse_computed(
                {.code = CurveErrorCode::point_beyond_horizon, .index = i, .value = factor * curve.weights()[i]});
    }
    return weights;
}

Result<Curve> with_mapped(const Curve& curve, std::span<const std::size_t> indices, const PlaneMap& map) {
    if (auto check = check_map(map); !check) return refuse(check.error());
    auto weights = map.is_affine() ? Result<std::vector<double>>() : mapped_weights(curve, indices, map);
    if (!weights) return refuse(weights.error());
    std::vector<Point> points(curve.control_points().begin(), curve.control_points().end());
    for (const std::size_t i : indices) {
        points[i] = mapped(map, curve.control_points()[i]);
        if (!is_finite(points[i])) return refuse({.code = CurveErrorCode::point_not_finite, .index = i});
    }
    if (map.is_affine()) return Trusted::with_points(curve, std::move(points));
    return Curve::make(curve.knots(), std::move(points), *std::move(weights));
}

}  // namespace

Result<Curve> transform(const Curve& curve, const PlaneMap& map) {
    std::vector<std::size_t> all(curve.control_points().size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return with_mapped(curve, all, map);
}

Result<Curve> transform_points(const Curve& curve, std::span<const std::size_t> indices, const PlaneMap& map) {
    for (const std::size_t index : indices)
        if (auto check = check_point_index(index, curve.control_points().size() - 1); !check)
            return refuse(check.error());
    return with_mapped(curve, indices, map);
}

MapDifference largest_map_difference(const Curve& curve, const PlaneMap& map, const Curve& image, int count) {
    assert(count >= 2);
    const Interval domain = curve.domain();
    MapDifference largest{0.0, domain.lower};
    for (int k = 0; k < count; ++k) {
        const double u = domain.clamp(std::lerp(domain.lower, domain.upper, k / (count - 1.0)));
        const double apart = robust_length(point_at(image, u) - mapped(map, point_at(curve, u)));
        // Also what is not a number is told.
        if (!(apart <= largest.distance)) largest = {apart, u};
    }
    return largest;
}

}  // namespace batten::core
