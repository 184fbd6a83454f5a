#include "app/editor/pointer/canvas_mode.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/shape_commands.h"
#include "app/editor/pointer/axis_pick.h"
#include "app/editor/pointer/canvas_press.h"
#include "app/editor/pointer/drawing.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/fit_point_drag.h"
#include "app/editor/pointer/gesture.h"
#include "app/editor/pointer/handlebar.h"
#include "app/editor/pointer/hit_test.h"
#include "app/editor/pointer/hover_request.h"
#include "app/editor/pointer/modes.h"
#include "app/editor/pointer/picture_drag.h"
#include "app/editor/pointer/placing_step.h"
#include "app/editor/pointer/point_drag.h"
#include "app/editor/pointer/selection_press.h"
#include "app/editor/pointer/transform_box.h"
#include "app/editor/pointer/weight_modes.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {
namespace {

// What is under the pointer; for the select tool a picture that it would drag, where that is nothing else.
Hover hit_of_tool(const Gesture& gesture) {
    const glm::dvec2 place = gesture.event.position_px;
    if (gesture.state.tool == Tool::transform) return hit_for_transform(gesture.state, place);
    const Hover hit = hit_canvas(gesture.state, place);
    if (gesture.state.tool != Tool::select || !std::holds_alternative<HoveredNothing>(hit)) return hit;
    const auto picture = picture_at(gesture.state, place);
    return picture ? Hover(HoveredPicture{*picture}) : hit;
}

// What would come of a click is not shown while nothing can be clicked.
void leave_canvas(const Gesture& gesture) {
    request_hover(HoveredNothing{}, gesture.state, gesture.queue);
    if (gesture.state.axis_pick && gesture.state.preview) gesture.queue.cancel_preview();
}

CanvasMode step(const CanvasIdle& mode, const Gesture& gesture) {
    if (is_press(gesture)) return begin_canvas_gesture(gesture);
    if (gesture.event.action == PointerAction::wheel) turn_canvas_wheel(gesture);
    if (gesture.event.action == PointerAction::leave) leave_canvas(gesture);
    if (gesture.event.action == PointerAction::take_back && gesture.state.axis_pick) take_axis_click_back(gesture);
    if (!is_move(gesture)) return mode;
    const Tool tool = gesture.state.tool;
    const bool shows_itself = (tool == Tool::joint || tool == Tool::brush) && is_about_tool(gesture);
    // These show themselves what a click would be about.
    if (gesture.state.axis_pick || shows_itself) request_hover(HoveredNothing{}, gesture.state, gesture.queue);
    if (gesture.state.axis_pick) {
        hover_axis(gesture);
        return mode;
    }
    if (shows_itself) return tool == Tool::joint ? begin_joint(gesture) : begin_brush(gesture);
    request_hover(hit_of_tool(gesture), gesture.state, gesture.queue);
    if (places_points(gesture.state.tool)) static_cast<void>(pointed_at(gesture));
    return mode;
}

void ask_to_move_points(const DraggingPoints& mode, const Gesture& gesture, Phase phase) {
    const core::Curve* curve = committed_curve(gesture.state);
    if (curve == nullptr || mode.grabbed >= curve->control_points().size()) return;
    const core::Point start = curve->control_points()[mode.grabbed];
    const core::Point target = dragged_position(gesture, start, mode.press_px, {.points = mode.indices});
    if (target == start) {
        gesture.queue.cancel_preview();
    } else if (mode.indices.size() == 1) {
        request(gesture, phase, SetPoint{.index = mode.grabbed, .position = target});
    } else {
        const core::Vector offset = exact_offset(start, target);
        request(gesture, phase, MovePoints{.points = mode.indices, .offset = offset});
    }
}

/// The pointer is over it then.
void show_handlebar(const Gesture& gesture, double u) {
    gesture.queue.run(ShowHandlebar{.u = u});
    request_hover(HoveredHandlebar{}, gesture.state, gesture.queue);
}

/// Where the curve runs through the point, Ctrl asks for its tangent there.
void click_on_point(const DraggingPoints& mode, const Gesture& gesture) {
    const core::Curve* curve = committed_curve(gesture.state);
    const bool wants_tangent = gesture.event.modifiers.ctrl && curve != nullptr && can_edit_curve(gesture.state);
    if (const auto u = wants_tangent ? parameter_at_point(*curve, mode.grabbed) : std::nullopt)
        return show_handlebar(gesture, *u);
    if (!mode.was_selected) return;
    std::vector<std::size_t> points{mode.grabbed};
    if (gesture.event.modifiers.shift) {
        points = mode.indices;
        points.erase(std::remove(points.begin(), points.end(), mode.grabbed), points.end());
    }
    if (points != gesture.state.selection.points) gesture.queue.run(SelectPoints{.points = points});
}

CanvasMode step(const DraggingPoints& mode, const Gesture& gesture) {
    if (!can_edit_curve(gesture.state) && is_move(gesture)) return mode;
    return step_edit(mode, gesture, ask_to_move_points, click_on_point);
}

void ask_to_set_weight(const DraggingWeight& mode, const Gesture& gesture, Phase phase) {
    const double weight =
        caught_weight(gesture.state, mode.index, dragged_weight(gesture, mode.start_weight, mode.press_px));
    if (weight == mode.start_weight)
        gesture.queue.cancel_preview();
    else
        request(gesture, phase, SetWeight{.index = mode.index, .weight = weight});
}

CanvasMode step(const DraggingWeight& mode, const Gesture& gesture) {
    return step_edit(mode, gesture, ask_to_set_weight, [](const auto&, const Gesture&) {});
}

/// The snap distance in parameter units where the curve passes u; 0 where it stands still.
double snap_distance_at(const Gesture& gesture, const core::Curve& curve, double u) {
    const double speed = core::length(core::derivatives_at(curve, u, 1)[1]);
    const double px_per_parameter = speed * gesture.state.view.camera.scale;
    return px_per_parameter > 0.0 ? pixels(gesture.state, snap_reach) / px_per_parameter : 0.0;
}

/// The knot that is near u on the screen, else u.
double knot_beside(const Gesture& gesture, const core::Curve& curve, double u) {
    return knot_near(curve.knots(), u, snap_distance_at(gesture, curve, u)).value_or(u);
}

void ask_to_move_knot(const DraggingCurveKnot& mode, const Gesture& gesture, Phase phase) {
    const core::Curve* curve = committed_curve(gesture.state);
    if (curve == nullptr) return;
    const double u = nearest_to_pointer(gesture).u;
    const double snap_distance = std::min(snap_distance_at(gesture, *curve, u), curve->domain().length());
    request(gesture, phase, dragged_knot(gesture.state, mode.index, u, snap_distance));
    request_hover(HoveredKnot{moving_knot(gesture.state, mode.index)}, gesture.state, gesture.queue);
}

CanvasMode step(const DraggingCurveKnot& mode, const Gesture& gesture) {
    return step_edit(mode, gesture, ask_to_move_knot, [](const auto&, const Gesture&) {});
}

void ask_to_move_curve(const DraggingCurvePoint& mode, const Gesture& gesture, Phase phase) {
    const core::Curve* curve = committed_curve(gesture.state);
    if (curve == nullptr) return;
    const core::Point start = core::point_at(*curve, mode.u);
    const core::Point target = dragged_position(gesture, start, mode.press_px, {.is_curve = true});
    if (target == start)
        gesture.queue.cancel_preview();
    else
        request(gesture, phase, MoveCurvePoint{.u = mode.u, .position = target});
}

CanvasMode step(const DraggingCurvePoint& mode, const Gesture& gesture) {
    return step_edit(mode, gesture, ask_to_move_curve, [](const auto& pressed, const Gesture& click) {
        const core::Curve* curve = committed_curve(click.state);
        const bool wants_knot = click.event.modifiers.ctrl && curve != nullptr;
        show_handlebar(click, wants_knot ? knot_beside(click, *curve, pressed.u) : pressed.u);
    });
}

CanvasMode step(BoxSelecting mode, const Gesture& gesture) {
    if (is_escape(gesture)) return CanvasIdle{};
    if (is_move(gesture)) mode.position_px = gesture.event.position_px;
    if (!is_release(gesture)) return mode;
    finish_box(mode, gesture);
    return CanvasIdle{};
}

CanvasMode step(const Panning& mode, const Gesture& gesture) {
    const PointerAction action = gesture.event.action;
    if (action == PointerAction::escape || action == PointerAction::release) return CanvasIdle{};
    if (action != PointerAction::move) return mode;
    const glm::dvec2 moved_px = gesture.event.position_px - mode.last_px;
    if (moved_px != glm::dvec2(0.0)) gesture.queue.change(PanCamera{moved_px});
    return Panning{gesture.event.position_px};
}

/// Of the place on the curve that is nearest to the pointer; with Ctrl, that of a knot that is near.
double pointed_parameter(const Gesture& gesture, const core::Curve& curve) {
    const double u = nearest_to_pointer(gesture).u;
    return gesture.event.modifiers.ctrl ? knot_beside(gesture, curve, u) : u;
}

CanvasMode step(const DraggingParameter& mode, const Gesture& gesture) {
    if (is_release(gesture) || committed_curve(gesture.state) == nullptr) return CanvasIdle{};
    if (is_escape(gesture)) {
        gesture.queue.run(SetParameter{.u = mode.start});
        return CanvasIdle{};
    }
    if (is_move(gesture)) {
        const double u = pointed_parameter(gesture, *committed_curve(gesture.state));
        if (u != gesture.state.parameter()) gesture.queue.run(SetParameter{.u = u});
    }
    return mode;
}

CanvasMode step(const DraggingHandle& mode, const Gesture& gesture) {
    if (is_escape(gesture)) {
        restore_handle(mode.start, gesture);
        return CanvasIdle{};
    }
    if (is_release(gesture)) return CanvasIdle{};
    if (is_move(gesture)) drag_handle(mode.start, gesture, mode.press_px);
    return mode;
}

CanvasMode step(const DrawingCurve& mode, const Gesture& gesture) {
    return step_drawing(mode, gesture);
}

CanvasMode step(const DraggingFitPoint& mode, const Gesture& gesture) {
    return step_fit_point_drag(mode, gesture);
}

CanvasMode step(const DraggingFitHandle& mode, const Gesture& gesture) {
    return step_fit_handle_drag(mode, gesture);
}

CanvasMode step(PencilStroke mode, const Gesture& gesture) {
    if (is_escape(gesture)) return CanvasIdle{};
    if (gesture.event.action == PointerAction::wheel) turn_canvas_wheel(gesture);
    if (is_release(gesture)) {
        finish_stroke(mode, gesture);
        return CanvasIdle{};
    }
    if (is_move(gesture)) draw_on(mode, gesture);
    return mode;
}

}  // namespace

void turn_canvas_wheel(const Gesture& gesture) {
    if (turn_wheel_over_inset(gesture)) return;
    if (const auto pan_px = wheel_pan(gesture.state, gesture.event)) {
        gesture.queue.change(PanCamera{{*pan_px, 0.0}});
        return;
    }
    const glm::dvec2 anchor = gesture.event.position_px;
    gesture.queue.change(ZoomCamera{std::pow(zoom_per_notch, gesture.event.wheel), anchor});
}

CanvasMode with_present_tool(CanvasMode mode, const EditorState& state, CommandQueue& queue) {
    if (auto* picking = std::get_if<PickingJoint>(&mode)) drop_gone_places(*picking, state);
    const auto* drawing = std::get_if<DrawingCurve>(&mode);
    if (drawing != nullptr && drawing->tool_changes != state.tool_changes) {
        keep_drawn(*drawing, state.view.pen_mode, queue);
        return CanvasIdle{};
    }
    const auto* shape = std::get_if<DrawingShape>(&mode);
    if (shape != nullptr && shape->tool_changes != state.tool_changes) return CanvasIdle{};
    const auto* stroke = std::get_if<PencilStroke>(&mode);
    if (stroke != nullptr && stroke->tool_changes != state.tool_changes) return CanvasIdle{};
    const auto* brush = std::get_if<Brushing>(&mode);
    if (brush != nullptr && brush->tool_changes != state.tool_changes) return CanvasIdle{};
    const auto* joint = std::get_if<PickingJoint>(&mode);
    if (joint != nullptr && joint->tool_changes != state.tool_changes) return CanvasIdle{};
    return mode;
}

bool is_at_rest(const CanvasMode& mode) {
    if (const auto* brush = std::get_if<Brushing>(&mode)) return !brush->press_px;
    if (const auto* joint = std::get_if<PickingJoint>(&mode)) return !joint->first && !joint->panned_px;
    return std::holds_alternative<CanvasIdle>(mode);
}

bool listens_to_drawing_keys(const CanvasMode& mode, const EditorState& state) {
    if (std::holds_alternative<CanvasIdle>(mode)) return state.axis_pick.has_value();
    const auto* joint = std::get_if<PickingJoint>(&mode);
    return std::holds_alternative<DrawingCurve>(mode) || std::holds_alternative<DrawingShape>(mode) ||
           (joint != nullptr && joint->first);
}

CanvasMode step_mode(const CanvasMode& mode, const Gesture& gesture) {
    return std::visit([&gesture](const auto& alternative) { return step(alternative, gesture); }, mode);
}

CanvasMode step_canvas(const CanvasMode& mode, const PointerEvent& event, const EditorState& state,
                       CommandQueue& queue) {
    return step_placing(with_present_tool(mode, state, queue), Gesture{event, state, queue}, step_mode);
}

}  // namespace batten::editor
