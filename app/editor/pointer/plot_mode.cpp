#include "app/editor/pointer/plot_mode.h"

#include <algorithm>
#include <cmath>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/view_commands.h"
#include "app/editor/pointer/gesture.h"
#include "app/editor/pointer/grid_step.h"
#include "app/editor/pointer/hit_test.h"
#include "app/editor/pointer/hover_request.h"

namespace batten::editor {
namespace {

constexpr double strip_reach = 16.0;  ///< design pixels above and below the strip's axis
constexpr double least_relative_range = 1e-13;

/// What a mode of the dock sees of one event.
struct PlotGesture : Gesture {
    PlotLayout layout;

    double px_per_unit() const { return (layout.right_px - layout.left_px) / layout.range.length(); }
    double pointed_parameter() const { return parameter_from_x(layout, event.position_px.x); }
    bool is_on_strip() const { return std::abs(event.position_px.y - layout.strip_px) <= pixels(state, strip_reach); }
};

bool is_release(const PlotGesture& gesture) {
    return gesture.event.action == PointerAction::release && gesture.event.button == PointerButton::left;
}

/// Shows `range`, or everything when it covers that. Kept inside the whole and wide enough for doubles to tell pixels
/// apart.
void show_range(const PlotGesture& gesture, core::Interval range) {
    const core::Interval whole = whole_plot_range(gesture.state);
    if (range.length() >= whole.length()) {
        gesture.queue.run(FitPlot{});
        return;
    }
    const double shift = std::max(0.0, whole.lower - range.lower) - std::max(0.0, range.upper - whole.upper);
    range = {range.lower + shift, range.upper + shift};
    const double size = std::max({std::abs(range.lower), std::abs(range.upper), whole.length()});
    if (range.length() < least_relative_range * size || range == gesture.layout.range) return;
    gesture.queue.change(SetPlotRange{range});
}

/// Moves what the zoomed plot shows by so many pixels to the right.
void pan(const PlotGesture& gesture, double moved_px) {
    const double shift = -moved_px / gesture.px_per_unit();
    const core::Interval range = gesture.layout.range;
    if (gesture.state.view.plot_range && shift != 0.0) show_range(gesture, {range.lower + shift, range.upper + shift});
}

void turn_wheel(const PlotGesture& gesture) {
    if (const auto pan_px = wheel_pan(gesture.state, gesture.event)) return pan(gesture, *pan_px);
    const double u = gesture.pointed_parameter();
    const double factor = std::pow(zoom_per_notch, -gesture.event.wheel);
    const core::Interval range = gesture.layout.range;
    show_range(gesture, {u + (range.lower - u) * factor, u + (range.upper - u) * factor});
}

/// With Ctrl, the knot that is near, else a round number.
double chosen_parameter(const PlotGesture& gesture, const core::Curve& curve) {
    const double u = gesture.pointed_parameter();
    if (!gesture.event.modifiers.ctrl) return u;
    const double reach = pixels(gesture.state, snap_reach) / gesture.px_per_unit();
    if (const auto knot = knot_near(curve.knots(), u, reach)) return *knot;
    return rounded_to_step(u, minor_grid_step(gesture.px_per_unit() / gesture.state.view.interface_scale));
}

void set_parameter(const PlotGesture& gesture) {
    const core::Curve* curve = gesture.state.active_curve();
    if (curve == nullptr) return;
    const double u = curve->domain().clamp(chosen_parameter(gesture, *curve));
    if (u != gesture.state.parameter()) gesture.queue.run(SetParameter{.u = u});
}

PlotMode press_knot(const PlotGesture& gesture, std::size_t index) {
    gesture.queue.run(SelectKnot{.index = index});
    const core::Curve* curve = committed_curve(gesture.state);
    if (!can_edit_curve(gesture.state) || index >= curve->knots().stored().size()) return PlotIdle{};
    return DraggingKnot{index, curve->knots().stored()[index] - gesture.pointed_parameter(),
                        gesture.event.position_px.x};
}

Hover pointed_thing(const PlotGesture& gesture) {
    return hit_plot(gesture.state, gesture.layout, gesture.event.position_px);
}

/// Whether a double click does anything that a press does not.
bool takes_double_click(const PlotGesture& gesture, const Hover& hit) {
    if (std::holds_alternative<HoveredKnot>(hit)) return true;
    const core::Curve* curve = gesture.state.active_curve();
    return curve != nullptr && gesture.is_on_strip() && curve->domain().contains(gesture.pointed_parameter());
}

void double_click(const PlotGesture& gesture, const Hover& hit) {
    if (!may_edit_curve(gesture)) return;
    if (const auto* knot = std::get_if<HoveredKnot>(&hit))
        gesture.queue.run(RaiseKnot{.index = knot->index});
    else
        gesture.queue.run(InsertKnot{.u = gesture.pointed_parameter()});
}

PlotMode press(const PlotGesture& gesture) {
    if (is_pan(gesture.event)) return PanningPlot{gesture.event.position_px.x};
    if (gesture.event.button != PointerButton::left || gesture.state.active_curve() == nullptr) return PlotIdle{};
    const Hover hit = pointed_thing(gesture);
    if (gesture.event.action == PointerAction::double_click && takes_double_click(gesture, hit))
        return DoubleClickingPlot{gesture.event};
    if (const auto* knot = std::get_if<HoveredKnot>(&hit)) return press_knot(gesture, knot->index);
    const double start = gesture.state.parameter();
    set_parameter(gesture);
    return DraggingPlotParameter{start};
}

PlotMode step(const PlotIdle& mode, const PlotGesture& gesture) {
    const PointerAction action = gesture.event.action;
    if (action == PointerAction::press || action == PointerAction::double_click) return press(gesture);
    if (action == PointerAction::wheel) turn_wheel(gesture);
    if (action == PointerAction::move) request_hover(pointed_thing(gesture), gesture.state, gesture.queue);
    if (action == PointerAction::leave) request_hover(HoveredNothing{}, gesture.state, gesture.queue);
    return mode;
}

/// The parameter to which the dragged knot is to go.
double dragged_parameter(const DraggingKnot& mode, const PlotGesture& gesture) {
    const double u = gesture.pointed_parameter() + mode.press_offset;
    if (!gesture.event.modifiers.ctrl) return u;
    return rounded_to_step(u, minor_grid_step(gesture.px_per_unit() / gesture.state.view.interface_scale));
}

void move_knot(const DraggingKnot& mode, const PlotGesture& gesture) {
    const MoveKnot command = dragged_knot(gesture.state, mode.index, dragged_parameter(mode, gesture),
                                          pixels(gesture.state, snap_reach) / gesture.px_per_unit());
    if (is_release(gesture))
        gesture.queue.run(command);
    else
        gesture.queue.preview(command);
    request_hover(HoveredKnot{moving_knot(gesture.state, mode.index)}, gesture.state, gesture.queue);
}

PlotMode step(DraggingKnot mode, const PlotGesture& gesture) {
    if (gesture.event.action == PointerAction::escape) {
        if (mode.has_moved) gesture.queue.cancel_preview();
        return PlotIdle{};
    }
    if (gesture.event.action != PointerAction::move && !is_release(gesture)) return mode;
    const double y = gesture.event.position_px.y;
    mode.has_moved = mode.has_moved || is_drag(gesture.state, {mode.press_x_px, y}, gesture.event.position_px);
    if (mode.has_moved) move_knot(mode, gesture);
    if (is_release(gesture)) return PlotIdle{};
    return mode;
}

PlotMode step(const DraggingPlotParameter& mode, const PlotGesture& gesture) {
    if (is_release(gesture)) return PlotIdle{};
    if (gesture.event.action == PointerAction::escape) {
        gesture.queue.run(SetParameter{.u = mode.start});
        return PlotIdle{};
    }
    if (gesture.event.action == PointerAction::move) set_parameter(gesture);
    return mode;
}

PlotMode step(const PanningPlot& mode, const PlotGesture& gesture) {
    const PointerAction action = gesture.event.action;
    if (action == PointerAction::escape || action == PointerAction::release) return PlotIdle{};
    if (action != PointerAction::move) return mode;
    const double x = gesture.event.position_px.x;
    pan(gesture, x - mode.last_x_px);
    return PanningPlot{x};
}

PlotMode step_mode(const PlotMode& mode, const PlotGesture& gesture);

PlotMode step(const DoubleClickingPlot& mode, const PlotGesture& gesture) {
    const PointerAction action = gesture.event.action;
    if (action == PointerAction::escape) return PlotIdle{};
    if (action != PointerAction::move && !is_release(gesture)) return mode;
    PointerEvent event = mode.press;
    event.action = PointerAction::press;
    const PlotGesture pressed{{event, gesture.state, gesture.queue}, gesture.layout};
    if (is_drag(gesture.state, event.position_px, gesture.event.position_px)) return step_mode(press(pressed), gesture);
    if (!is_release(gesture)) return mode;
    if (const Hover hit = pointed_thing(pressed); takes_double_click(pressed, hit)) double_click(pressed, hit);
    return PlotIdle{};
}

PlotMode step_mode(const PlotMode& mode, const PlotGesture& gesture) {
    return std::visit([&gesture](const auto& current) { return step(current, gesture); }, mode);
}

}  // namespace

PlotMode step_plot(const PlotMode& mode, const PointerEvent& event, const EditorState& state, glm::dvec2 size_px,
                   CommandQueue& queue) {
    return step_mode(mode, PlotGesture{{event, state, queue}, plot_layout(state, size_px)});
}

}  // namespace batten::editor
