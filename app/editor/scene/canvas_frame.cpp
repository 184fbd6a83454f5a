#include "app/editor/scene/canvas_frame.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/state/point_hues.h"

namespace batten::editor {

namespace {

constexpr double farthest_px = 1e30;
constexpr double candidates_per_px = 8.0;
constexpr double least_frame_width_px = 100.0;

}  // namespace

glm::dvec2 shown_place(const render::Camera& camera, core::Point world) {
    const glm::dvec2 place = render::screen_from_world(camera, world);
    return {std::clamp(place.x, -farthest_px, farthest_px), std::clamp(place.y, -farthest_px, farthest_px)};
}

CanvasFrame::CanvasFrame(const EditorState& shown_state, SceneCache& scene_cache, render::DrawList& list)
    : state(shown_state),
      cache(scene_cache),
      theme(shown_theme(shown_state.view)),
      pen(list, shown_state.view.camera.size_px, shown_state.view.interface_scale, shown_state.view.notation),
      curve(shown_state.visible_active_curve()) {
    if (curve == nullptr) return;
    lit = highlight(state);
    triangle = core::de_boor_triangle(*curve, state.view.parameter);
    const core::Document& document = state.shown();
    kept = &cache.curve(document.active, document.active_curve()->curve);
    curve_line = seen_curve(*this, *kept, {.color = theme.curve, .width = active_curve_width});
}

std::size_t CanvasFrame::hue(std::size_t i) const {
    return point_hue(*state.shown().active_curve(), i);
}

bool CanvasFrame::is_pinned(std::size_t i) const {
    return std::ranges::binary_search(state.shown().active_curve()->pinned, i);
}

void CanvasFrame::keep_free(glm::dvec2 place, double radius) {
    const glm::dvec2 reach(pen.px(radius));
    covered.push_back({place - reach, place + reach});
}

void CanvasFrame::keep_free(glm::dvec2 a, glm::dvec2 b, double radius) {
    constexpr double most_boxes = 160.0;
    const double boxes = std::clamp(std::ceil(glm::distance(a, b) / pen.px(2.0 * radius)), 1.0, most_boxes);
    for (double k = 0.0; k <= boxes; k += 1.0) keep_free(a + k / boxes * (b - a), radius);
}

glm::dvec2 CanvasFrame::screen(core::Point world) const {
    return shown_place(state.view.camera, world);
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

std::size_t most_candidates(const CanvasFrame& frame) {
    return static_cast<std::size_t>(candidates_per_px *
                                    std::max(frame.state.view.camera.size_px.x, least_frame_width_px));
}

core::Interval active_span(const CanvasFrame& frame) {
    const core::KnotVector& knots = frame.curve->knots();
    return {knots[frame.triangle->span], knots[frame.triangle->span + 1]};
}

}  // namespace batten::editor
