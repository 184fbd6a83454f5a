#include "app/editor/derived/map_check.h"

#include <algorithm>
#include <cmath>

#include "app/editor/words/wording.h"
#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

// The image of the control points with the weights as they were.
core::Result<core::Curve> with_weights_kept(const core::Curve& curve, const core::Curve& image) {
    return core::Curve::make(curve.knots(), {image.control_points().begin(), image.control_points().end()},
                             {curve.weights().begin(), curve.weights().end()});
}

// Points at even parameters.
std::vector<core::Point> even_points(const core::Curve& curve) {
    std::vector<core::Point> points;
    const core::Interval domain = curve.domain();
    for (int k = 0; k < compared_parameters; ++k)
        points.push_back(core::point_at(
            curve, domain.clamp(std::lerp(domain.lower, domain.upper, k / (compared_parameters - 1.0)))));
    return points;
}

}  // namespace

bool MapCheck::agrees() const {
    constexpr double rounding = 1e-12;
    return image && difference.distance <= rounding * largest_coordinate(box);
}

MapCheck check_map(const MappedCurve& mapped) {
    const auto& [curve, map] = mapped;
    MapCheck check{.image = core::transform(curve, map)};
    if (!check.image) return check;
    check.box = core::control_box(curve);
    const core::Box after = core::control_box(*check.image);
    check.box.include(after.lower);
    check.box.include(after.upper);
    check.points = even_points(curve);
    for (const core::Point point : check.points) check.evaluated_first.push_back(core::mapped(map, point));
    check.mapped_first = even_points(*check.image);
    check.difference = core::largest_map_difference(curve, map, *check.image, compared_parameters);
    if (map.is_affine()) return check;
    if (const auto kept = with_weights_kept(curve, *check.image)) {
        check.weights_kept = even_points(*kept);
        check.kept_difference = core::largest_map_difference(curve, map, *kept, compared_parameters);
    }
    return check;
}

}  // namespace batten::editor
