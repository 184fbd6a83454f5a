#include "app/editor/scene/canvas_frame.h"

#include <algorithm>

#include "core/evaluate/tessellate.h"

namespace batten::editor {

namespace {

constexpr double tolerance_px = 0.25;
constexpr double stroke_margin_px = 8.0;
constexpr double farthest_px = 1e30;

}  // namespace

CanvasFrame::CanvasFrame(const EditorState& shown_state, render::DrawList& list)
    : state(shown_state),
      theme(theme_of(shown_state.view.theme)),
      pen(list, shown_state.view.camera.size_px, shown_state.view.interface_scale),
      curve(shown_state.visible_active_curve()) {
    if (curve == nullptr) return;
    lit = highlight(state);
    triangle = core::de_boor_triangle(*curve, state.view.parameter);
    curve_runs = seen_runs(*this, *curve, curve->domain());
}

glm::dvec2 CanvasFrame::screen(core::Point world) const {
    const glm::dvec2 place = render::screen_from_world(state.view.camera, world);
    return {std::clamp(place.x, -farthest_px, farthest_px), std::clamp(place.y, -farthest_px, farthest_px)};
}

std::vector<glm::dvec2> CanvasFrame::screen(std::span<const core::Point> world) const {
    std::vector<glm::dvec2> places;
    places.reserve(world.size() + 1);
    for (const core::Point point : world) places.push_back(screen(point));
    return places;
}

core::Box CanvasFrame::seen(double margin_px) const {
    const render::Camera& camera = state.view.camera;
    core::Box box;
    box.include(core::Point(render::world_from_screen(camera, glm::dvec2(-margin_px))));
    box.include(core::Point(render::world_from_screen(camera, camera.size_px + glm::dvec2(margin_px))));
    return box;
}

std::vector<std::vector<glm::dvec2>> seen_runs(const CanvasFrame& frame, const core::Curve& curve,
                                               core::Interval range) {
    const core::TessellationRequest request{tolerance_px / frame.state.view.camera.scale,
                                            frame.seen(frame.pen.px(stroke_margin_px)), range};
    std::vector<std::vector<glm::dvec2>> runs;
    for (const auto& samples : core::tessellate(curve, request)) {
        auto& run = runs.emplace_back();
        run.reserve(samples.size());
        for (const core::CurveSample& sample : samples) run.push_back(frame.screen(sample.point));
    }
    return runs;
}

core::Interval active_span(const CanvasFrame& frame) {
    const core::KnotVector& knots = frame.curve->knots();
    return {knots[frame.triangle->span], knots[frame.triangle->span + 1]};
}

}  // namespace batten::editor
