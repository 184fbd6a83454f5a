#include "app/editor/canvas_cover.h"

#include "core/evaluate/tessellate.h"
#include "render/clip.h"

namespace batten::editor {

namespace {

using render::Camera;
using render::PixelBox;

// Design pixels.
constexpr double point_reach = 16.0;  // of the box around the first point
constexpr double line_reach = 4.0;
constexpr double tolerance = 1.0;

constexpr int point_cost = 4;
constexpr int curve_cost = 2;

PixelBox grown(const PixelBox& box, double by_px) {
    return {box.lower_px - by_px, box.upper_px + by_px};
}

core::Box world_box(const Camera& camera, const PixelBox& box) {
    core::Box world;
    world.include(core::Point(render::world_from_screen(camera, box.lower_px)));
    world.include(core::Point(render::world_from_screen(camera, box.upper_px)));
    return world;
}

bool is_crossed(const Camera& camera, const PixelBox& box, core::Point a, core::Point b) {
    return render::clip_segment(box, render::screen_from_world(camera, a), render::screen_from_world(camera, b))
        .has_value();
}

bool passes(const core::Curve& curve, const Camera& camera, const PixelBox& box, double tolerance_px) {
    const core::TessellationRequest request{tolerance_px / camera.scale, world_box(camera, box), curve.domain()};
    for (const auto& run : core::tessellate(curve, request))
        for (std::size_t i = 0; i + 1 < run.size(); ++i)
            if (is_crossed(camera, box, run[i].point, run[i + 1].point)) return true;
    return false;
}

int covered_polygon(const core::Curve& curve, const Camera& camera, const PixelBox& around_points,
                    const PixelBox& around_legs) {
    int sum = 0;
    const auto points = curve.control_points();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (around_points.contains(render::screen_from_world(camera, points[i]))) sum += point_cost;
        const bool has_leg = i + 1 < points.size() || curve.is_periodic();
        if (has_leg && is_crossed(camera, around_legs, points[i], points[(i + 1) % points.size()])) ++sum;
    }
    return sum;
}

}  // namespace

int covered(const EditorState& state, const Camera& camera, const PixelBox& box) {
    const double scale = state.view.interface_scale;
    const PixelBox around_lines = grown(box, line_reach * scale);
    const core::DocumentCurve* active = state.shown().active_curve();
    int sum = 0;
    for (const core::DocumentCurve& item : state.shown().curves) {
        if (!item.visible) continue;
        if (passes(*item.curve, camera, around_lines, tolerance * scale)) sum += curve_cost;
        if (&item == active && state.view.overlays.is_shown(Overlay::polygon))
            sum += covered_polygon(*item.curve, camera, grown(box, point_reach * scale), around_lines);
    }
    return sum;
}

}  // namespace batten::editor
