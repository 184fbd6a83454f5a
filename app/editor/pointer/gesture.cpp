#include "app/editor/pointer/gesture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/commands/active_curve.h"

namespace batten::editor {
namespace {

constexpr double least_drag = 3.0;

}  // namespace

const TypedPlace& typed_for(const Gesture& gesture) {
    return gesture.typed != nullptr ? *gesture.typed : gesture.state.placing.typed;
}

bool is_typed(const Gesture& gesture) {
    return !typed_for(gesture).is_empty();
}

double pixels(const EditorState& state, double design_px) {
    return design_px * state.view.interface_scale;
}

core::Point world_at_pointer(const Gesture& gesture) {
    return core::Point(render::world_from_screen(gesture.state.view.camera, gesture.event.position_px));
}

bool is_drag(const EditorState& state, glm::dvec2 press_px, glm::dvec2 position_px) {
    return glm::distance(press_px, position_px) >= pixels(state, least_drag);
}

bool is_pan(const PointerEvent& event) {
    return event.button == PointerButton::middle || (event.button == PointerButton::left && event.space_is_held);
}

bool step_pan(std::optional<glm::dvec2>& panned_px, const Gesture& gesture) {
    const PointerEvent& event = gesture.event;
    const bool is_press = event.action == PointerAction::press || event.action == PointerAction::double_click;
    if (is_press && is_pan(event)) {
        panned_px = event.position_px;
        return true;
    }
    if (!panned_px) return false;
    if (event.action == PointerAction::release) panned_px.reset();
    if (event.action != PointerAction::move) return is_press || event.action == PointerAction::release;
    const glm::dvec2 moved_px = event.position_px - *panned_px;
    if (moved_px != glm::dvec2(0.0)) gesture.queue.change(PanCamera{moved_px});
    panned_px = event.position_px;
    return true;
}

std::optional<double> wheel_pan(const EditorState& state, const PointerEvent& event) {
    // The fingers on a touchpad never move quite straight: the larger of both directions is meant.
    const bool is_sideways = std::abs(event.sideways_wheel) > std::abs(event.wheel);
    if (!is_sideways && !event.modifiers.shift) return std::nullopt;
    return pixels(state, pan_per_notch) * (is_sideways ? event.sideways_wheel : event.wheel);
}

const core::Curve* committed_curve(const EditorState& state) {
    const core::DocumentCurve* item = state.history.present().active_curve();
    return item == nullptr ? nullptr : item->curve.get();
}

core::CurveSample nearest_to_pointer(const Gesture& gesture) {
    const EditorState& state = gesture.state;
    const auto& curve = state.history.present().active_curve()->curve;
    return state.derived.near_parts(curve)->nearest(world_at_pointer(gesture)).value();
}

bool can_edit_curve(const EditorState& state) {
    return !no_curve_at_hand(state);
}

bool may_edit_curve(const Gesture& gesture) {
    const std::optional<Refusal> refusal = no_curve_at_hand(gesture.state);
    if (refusal) gesture.queue.change(ShowRefusal{*refusal});
    return !refusal;
}

double rounded_to_step(double value, double step) {
    // 1/step is whole for a decimal step below 1; dividing by it rounds once, multiplying by the step would round
    // twice.
    if (step < 1.0) {
        const double steps_per_unit = std::round(1.0 / step);
        return std::round(value * steps_per_unit) / steps_per_unit;
    }
    return std::round(value / step) * step;
}

std::optional<double> knot_near(const core::KnotVector& knots, double u, double reach) {
    const std::span<const double> stored = knots.stored();
    const auto above = std::lower_bound(stored.begin(), stored.end(), u);
    std::optional<double> nearest;
    if (above != stored.end()) nearest = *above;
    if (above != stored.begin() && (!nearest || u - *(above - 1) < *nearest - u)) nearest = *(above - 1);
    return nearest && std::abs(*nearest - u) <= reach ? nearest : std::nullopt;
}

MoveKnot dragged_knot(const EditorState& state, std::size_t index, double u, double snap_distance) {
    MoveKnot command{.index = index, .u = u, .mode = state.view.knot_move};
    if (command.mode == core::KnotMove::snap) command.snap_distance = snap_distance;
    return command;
}

std::size_t moving_knot(const EditorState& state, std::size_t index) {
    const core::Curve* before = committed_curve(state);
    const core::Curve* now = state.active_curve();
    if (before == nullptr || now == nullptr) return index;
    const std::span<const double> old_knots = before->knots().stored();
    const std::span<const double> new_knots = now->knots().stored();
    if (index >= old_knots.size() || new_knots.size() != old_knots.size()) return index;
    for (std::size_t i = 0; i < old_knots.size(); ++i)
        if (old_knots[i] == old_knots[index] && new_knots[i] != old_knots[i]) return i;
    return index;
}

}  // namespace batten::editor
