#include "app/editor/scene/sketch_scene.h"

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

namespace {

// Design pixels.
constexpr double sketch_margin = 56.0;
constexpr double sketch_radius = 1.5;

}  // namespace

bool has_sketch(const EditorState& state) {
    return state.at_work && !state.at_work->sketch.points().empty();
}

// Without lines, which would show another shape where points between are left out.
render::DrawList sketch_scene(const EditorState& state) {
    const std::vector<core::Point>& points = state.at_work->sketch.points();
    const double scale = state.view.interface_scale;
    core::Box box;
    for (const core::Point point : points) box.include(point);
    const render::Camera camera = render::fitted(state.view.camera, box.lower, box.upper, sketch_margin * scale);
    const Symbol dot{.radius = sketch_radius, .fill = shown_theme(state.view).polygon, .outline = no_color};
    render::DrawList list;
    Pen pen(list, camera.size_px, scale);
    for (const core::Point point : points) pen.symbol(shown_place(camera, point), dot);
    return list;
}

}  // namespace batten::editor
