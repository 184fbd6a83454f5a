#include <algorithm>
#include <cmath>

#include "app/editor/commands/tool_commands.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/modes.h"
#include "app/editor/pointer/point_drag.h"
#include "app/editor/pointer/shape_commands.h"
#include "app/editor/pointer/typed_place.h"

namespace batten::editor {
namespace {

/// What lengths and angles to the next place are measured from: for a shape with a center, always that.
core::Point measured_from(const DrawingShape& mode) {
    const bool has_center = mode.kind == ShapeKind::arc || mode.kind == ShapeKind::ellipse;
    return has_center ? mode.points.front() : mode.points.back();
}

/// The corner of a square with the same diagonal's longer side.
core::Point square_corner(core::Point from, core::Point to) {
    const core::Vector way = to - from;
    const double side = std::max(std::abs(way.x), std::abs(way.y));
    return {from.x + std::copysign(side, way.x), from.y + std::copysign(side, way.y)};
}

core::Point next_place(const DrawingShape& mode, const Gesture& gesture) {
    const core::Point from = measured_from(mode);
    if (mode.kind != ShapeKind::rectangle || !gesture.event.modifiers.shift) return pointed_at(gesture, from);
    PointerEvent event = gesture.event;
    event.modifiers.shift = false;
    const core::Point place =
        pointed_at(Gesture{event, gesture.state, gesture.queue, gesture.typed, gesture.place}, from);
    return square_corner(from, place);
}

ShapeHints hints_of(const DrawingShape& mode, const Gesture& gesture) {
    const TypedPlace& typed = typed_for(gesture);
    const Units& units = gesture.state.shown().units;
    // A length in no direction is how far an ellipse reaches from its first axis.
    const auto length = mode.kind == ShapeKind::ellipse ? typed_length_alone(typed, units) : typed_length(typed, units);
    return {gesture.state.view.polygon_sides, length, mode.turned};
}

DrawingShape moved(DrawingShape mode, core::Point next) {
    if (mode.points.size() == 2) {
        const core::Point center = mode.points.front();
        const core::Point before = mode.next == center ? mode.points.back() : mode.next;
        mode.turned += core::angle_between(before - center, next - center);
    }
    mode.next = next;
    return mode;
}

bool is_complete(const DrawingShape& mode) {
    return mode.points.size() + 1 == place_count(mode.kind);
}

Outcome<Command> command_of(const DrawingShape& mode, const Gesture& gesture) {
    std::vector<core::Point> places = mode.points;
    places.push_back(mode.next);
    return shape_command(mode.kind, places, hints_of(mode, gesture));
}

CanvasMode follow_pointer(DrawingShape mode, const Gesture& gesture) {
    const core::Point next = next_place(mode, gesture);
    mode = moved(std::move(mode), next);
    if (!is_complete(mode)) return mode;
    if (const auto command = command_of(mode, gesture))
        gesture.queue.preview(*command);
    else
        gesture.queue.cancel_preview();
    return mode;
}

CanvasMode take_place(DrawingShape mode, const Gesture& gesture) {
    const core::Point next = next_place(mode, gesture);
    mode = moved(std::move(mode), next);
    if (mode.next == mode.points.back()) {
        if (is_typed(gesture)) gesture.queue.change(ShowRefusal{"the next place must be another one than the last"});
        return mode;
    }
    if (!is_complete(mode)) {
        mode.points.push_back(mode.next);
        mode.turned = 0.0;
        return mode;
    }
    const auto command = command_of(mode, gesture);
    if (!command) {
        gesture.queue.change(ShowRefusal{command.error()});
        return mode;
    }
    gesture.queue.run(*command);
    return CanvasIdle{};
}

CanvasMode give_up_shape(const Gesture& gesture) {
    gesture.queue.cancel_preview();
    return CanvasIdle{};
}

CanvasMode take_back(DrawingShape mode, const Gesture& gesture) {
    gesture.queue.cancel_preview();
    mode.points.pop_back();
    mode.turned = 0.0;
    return mode.points.empty() ? CanvasMode(CanvasIdle{}) : CanvasMode(mode);
}

}  // namespace

CanvasMode begin_shape(const Gesture& gesture) {
    const core::Point place = pointed_at(gesture);
    return DrawingShape{gesture.state.view.shape_kind, {place}, place, 0.0, gesture.state.tool_changes};
}

CanvasMode step(DrawingShape mode, const Gesture& gesture) {
    if (step_pan(mode.panned_px, gesture)) return mode;
    const bool is_right_click =
        gesture.event.action == PointerAction::release && gesture.event.button == PointerButton::right;
    if (is_escape(gesture) || is_right_click) return give_up_shape(gesture);
    if (gesture.event.action == PointerAction::take_back) return take_back(std::move(mode), gesture);
    if (gesture.event.action == PointerAction::wheel) turn_canvas_wheel(gesture);
    if (is_move(gesture)) return follow_pointer(mode, gesture);
    if (is_press(gesture) && gesture.event.button == PointerButton::left) return take_place(mode, gesture);
    return mode;
}

}  // namespace batten::editor
