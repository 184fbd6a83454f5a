#include "app/editor/pointer/view_handle.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/pointer/comb_tooth.h"
#include "app/editor/pointer/nearest.h"
#include "app/editor/pointer/point_drag.h"

namespace batten::editor {

namespace {

constexpr double handle_reach = 9.0;
constexpr double probe_line_reach = 5.0;

core::Point end_of(const ProbeLine& line, ViewHandle handle) {
    return handle == ViewHandle::line_second ? line.second : line.first;
}

ProbeLine dragged_line(const HandleStart& start, const Gesture& gesture, glm::dvec2 press_px) {
    ProbeLine line = start.line;
    const core::Point before = end_of(line, start.handle);
    const core::Point after = dragged_position(gesture, before, press_px);
    if (start.handle != ViewHandle::line_second) line.first = after;
    if (start.handle == ViewHandle::line_second) line.second = after;
    if (start.handle == ViewHandle::line) line.second = line.second + (after - before);
    return line;
}

}  // namespace

std::optional<ProbeLine> shown_probe_line(const EditorState& state) {
    if (state.visible_active_curve() == nullptr || !state.view.overlays.is_shown(Overlay::variation))
        return std::nullopt;
    if (state.view.shape.line) return state.view.shape.line;
    const core::Curve* committed = committed_curve(state);
    return level_line_through(committed != nullptr ? *committed : *state.visible_active_curve());
}

std::optional<ViewHandle> handle_at(const EditorState& state, glm::dvec2 position_px) {
    if (state.tool != Tool::select) return std::nullopt;
    Nearest<ViewHandle> nearest(pixels(state, handle_reach));
    const auto offer = [&](ViewHandle handle, glm::dvec2 place_px) {
        nearest.offer(handle, glm::distance(place_px, position_px));
    };
    if (const auto line = shown_probe_line(state)) {
        offer(ViewHandle::line_first, render::screen_from_world(state.view.camera, line->first));
        offer(ViewHandle::line_second, render::screen_from_world(state.view.camera, line->second));
    }
    if (const auto comb = comb_handle(state, state.view.shape.comb_factor)) offer(ViewHandle::comb, comb->place_px);
    return nearest.found();
}

bool is_on_probe_line(const EditorState& state, glm::dvec2 position_px) {
    const auto line = shown_probe_line(state);
    if (!line || state.tool != Tool::select) return false;
    const core::Point place(render::world_from_screen(state.view.camera, position_px));
    const core::Vector chord = line->second - line->first;
    const core::Vector along = chord / core::robust_length(chord);
    return std::abs(core::cross(along, place - line->first)) * state.view.camera.scale <=
           pixels(state, probe_line_reach);
}

HandleStart start_of(const EditorState& state, ViewHandle handle) {
    return {handle, state.view.shape.comb_factor, shown_probe_line(state).value_or(ProbeLine{{0.0, 0.0}, {1.0, 0.0}})};
}

void drag_handle(const HandleStart& start, const Gesture& gesture, glm::dvec2 press_px) {
    if (start.handle == ViewHandle::comb) {
        const glm::dvec2 moved_px = gesture.event.position_px - press_px;
        gesture.queue.change(SetCombFactor{dragged_comb_factor(gesture.state, start.comb_factor, moved_px)});
        return;
    }
    const ProbeLine line = dragged_line(start, gesture, press_px);
    if (is_line(line)) gesture.queue.change(SetProbeLine{line});
}

void restore_handle(const HandleStart& start, const Gesture& gesture) {
    if (start.handle == ViewHandle::comb)
        gesture.queue.change(SetCombFactor{start.comb_factor});
    else
        gesture.queue.change(SetProbeLine{start.line});
}

}  // namespace batten::editor
