#include "app/editor/pointer/canvas_cover.h"

#include "render/clip.h"

namespace batten::editor {

namespace {

using render::Camera;
using render::PixelBox;

// Design pixels.
constexpr double cover_point_reach = 16.0;  // of the box around the first point
constexpr double cover_line_reach = 4.0;
constexpr double tolerance = 1.0;

constexpr std::size_t most_covered_places = 2000;  // of lines in a box; more are not counted

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

/// How many pieces of the polylines cross the box.
int crossings(const Camera& camera, const PixelBox& box, const core::PointRuns& runs) {
    int sum = 0;
    for (const auto& run : runs)
        for (std::size_t i = 0; i + 1 < run.size(); ++i)
            if (render::clip_segment(box, render::screen_from_world(camera, run[i]),
                                     render::screen_from_world(camera, run[i + 1])))
                ++sum;
    return sum;
}

core::StripRequest request_in(const Camera& camera, const PixelBox& box, double tolerance_px) {
    return {tolerance_px / camera.scale, world_box(camera, box), most_covered_places};
}

bool passes(core::CurveStrips& strips, const Camera& camera, const PixelBox& box, double tolerance_px) {
    const core::StripRequest request = request_in(camera, box, tolerance_px);
    const auto runs = strips.runs(request, strips.curve()->domain());
    return !runs || crossings(camera, box, *runs) > 0;
}

int covered_polygon(const core::PolygonStrips& polygon, const Camera& camera, const PixelBox& around_points,
                    const PixelBox& around_legs, double tolerance_px) {
    const auto legs = polygon.runs(request_in(camera, around_legs, tolerance_px));
    int sum = legs ? crossings(camera, around_legs, legs->runs) : static_cast<int>(most_covered_places);
    polygon.visit_points(world_box(camera, around_points), 0.0, most_covered_places,
                         [&](std::size_t, core::Point, std::size_t) { sum += point_cost; });
    return sum;
}

}  // namespace

int covered(const EditorState& state, const Camera& camera, const PixelBox& box, SceneCache& cache) {
    const double scale = state.view.interface_scale;
    const PixelBox around_lines = grown(box, cover_line_reach * scale);
    const core::DocumentCurve* active = state.shown().active_curve();
    int sum = 0;
    const std::vector<core::DocumentCurve>& curves = state.shown().curves;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (!curves[i].visible) continue;
        KeptCurve& kept = cache.curve(i, curves[i].curve);
        if (passes(kept.strips(), camera, around_lines, tolerance * scale)) sum += curve_cost;
        if (&curves[i] == active && state.view.overlays.is_shown(Overlay::polygon))
            sum += covered_polygon(kept.polygon(), camera, grown(box, cover_point_reach * scale), around_lines,
                                   tolerance * scale);
    }
    return sum;
}

}  // namespace batten::editor
