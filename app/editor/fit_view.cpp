#include "app/editor/fit_view.h"

#include "core/curve/control_box.h"

namespace batten::editor {

namespace {

constexpr double margin = 56.0;         // design pixels: room for the labels of points at the rim
constexpr double largest_share = 0.15;  // of a small picture that the margin may take
constexpr double default_scale = 64.0;

core::Box visible_box(const core::Document& document) {
    core::Box box;
    for (const core::DocumentCurve& item : document.curves) {
        if (!item.visible) continue;
        const core::Box curve_box = core::control_box(*item.curve);
        box.include(curve_box.lower);
        box.include(curve_box.upper);
    }
    return box;
}

}  // namespace

void fit_view(EditorState& state) {
    render::Camera& camera = state.view.camera;
    const core::Box box = visible_box(state.shown());
    if (box.is_empty()) {
        camera.center = {0.0, 0.0};
        camera.scale = default_scale * state.view.interface_scale;
        return;
    }
    const double smaller_px = std::min(camera.size_px.x, camera.size_px.y);
    const double margin_px = std::min(margin * state.view.interface_scale, largest_share * smaller_px);
    camera = render::fitted(camera, box.lower, box.upper, margin_px);
}

}  // namespace batten::editor
