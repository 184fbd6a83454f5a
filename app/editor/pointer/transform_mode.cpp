#include "app/editor/pointer/transform_mode.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/editor/commands/selection_commands.h"
#include "app/editor/fields/quantity.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/modes.h"
#include "app/editor/pointer/point_drag.h"
#include "app/editor/pointer/transform_box.h"
#include "app/editor/pointer/typed_place.h"
#include "app/editor/words/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {
namespace {

using core::sentence;

/// What a drag does: nothing yet where there is no command.
struct Transformation {
    std::optional<Command> command{};
    core::PlaneMap map{};
    std::string reading{};
    TypedFor typed_for = TypedFor::factors;
};

Dragged dragged_by(const TransformBox& box) {
    return {.is_curve = box.is_of_active_curve(), .parts = box.selected->parts};
}

/// Where the pointer leads what was at `start`: with keys that mean something else here left out, and without what is
/// typed, which is no place.
core::Point led_from(const Gesture& gesture, core::Point start, glm::dvec2 press_px, const TransformBox& box,
                     bool keeps_grid) {
    PointerEvent event = gesture.event;
    event.modifiers.shift = false;
    event.modifiers.ctrl = event.modifiers.ctrl && keeps_grid;
    const TypedPlace nothing;
    return dragged_position(Gesture{event, gesture.state, gesture.queue, &nothing, gesture.place}, start, press_px,
                            dragged_by(box));
}

/// The point that stays: the pivot that was chosen, else what is opposite.
core::Point anchor_of(const TransformBox& box, TransformGrip grip) {
    if (box.has_own_pivot) return box.pivot;
    return grip_point(box, {grip.kind, -grip.x, -grip.y});
}

/// How much longer the way from the anchor became along one axis; 1 where there was none.
double factor_along(int direction, double anchor, double start, double target) {
    return direction == 0 || start == anchor ? 1.0 : (target - anchor) / (start - anchor);
}

struct Factors {
    double x = 1.0;
    double y = 1.0;
};

Factors dragged_factors(const DraggingTransform& mode, const Gesture& gesture, const TransformBox& box) {
    const core::Point anchor = anchor_of(box, mode.grip);
    const core::Point start = grip_point(box, mode.grip);
    const core::Point target = led_from(gesture, start, mode.press_px, box, true);
    if (!gesture.event.modifiers.shift)
        return {factor_along(mode.grip.x, anchor.x, start.x, target.x),
                factor_along(mode.grip.y, anchor.y, start.y, target.y)};
    // The same along both axes: as far as the pointer went along the way from the anchor.
    const core::Vector way(mode.grip.x != 0 ? start.x - anchor.x : 0.0, mode.grip.y != 0 ? start.y - anchor.y : 0.0);
    const double squared = core::dot(way, way);
    const double factor = squared > 0.0 ? core::dot(target - anchor, way) / squared : 1.0;
    return {factor, factor};
}

/// A single number at a corner is for both axes, at a side for its own.
Factors typed_factors(const DraggingTransform& mode, const TypedPlace& typed, Factors dragged) {
    const auto first = typed_factor(typed, 0);
    const auto second = typed_factor(typed, 1);
    const bool is_side = mode.grip.x == 0 || mode.grip.y == 0;
    const bool is_of_y = is_side && mode.grip.y != 0 && !typed.has_offsets && !second;
    if (is_of_y && first) return {1.0, *first};
    const bool is_for_both = !is_side && !typed.has_offsets && first && !second;
    if (is_for_both) return {*first, *first};
    return {first.value_or(dragged.x), second.value_or(dragged.y)};
}

std::string percent_text(double factor) {
    return sentence("{percent} %", {{"percent", number_text(100.0 * factor, 4)}});
}

Transformation scaled(const DraggingTransform& mode, const Gesture& gesture, const TransformBox& box) {
    const core::Point pivot = anchor_of(box, mode.grip);
    const Factors dragged = dragged_factors(mode, gesture, box);
    const auto [x, y] = typed_factors(mode, typed_for(gesture), dragged);
    Transformation made;
    made.reading = x == y ? percent_text(x) : sentence("{x} × {y}", {{"x", percent_text(x)}, {"y", percent_text(y)}});
    const bool is_possible = std::isfinite(x) && std::isfinite(y) && x != 0.0 && y != 0.0;
    if (!is_possible || (x == 1.0 && y == 1.0)) return made;
    made.map = core::scaling(x, y, pivot);
    made.command = x == y ? Command(Scale{.factor = x, .what = box.what, .pivot = pivot})
                          : Command(Stretch{.along_x = x, .along_y = y, .what = box.what, .pivot = pivot});
    return made;
}

double rounded_angle(const Gesture& gesture, double angle) {
    return gesture.event.modifiers.ctrl ? rounded_to_step(angle, gesture.state.view.snap.angle_step) : angle;
}

Transformation turned(const DraggingTransform& mode, const Gesture& gesture, const TransformBox& box) {
    constexpr double half_turn = 180.0;
    const core::Point press(render::world_from_screen(gesture.state.view.camera, mode.press_px));
    const core::Vector before = press - box.pivot;
    const core::Vector now = world_at_pointer(gesture) - box.pivot;
    const bool has_angle = before != core::Vector(0.0, 0.0) && now != core::Vector(0.0, 0.0);
    const double dragged = has_angle ? core::angle_between(before, now) * half_turn / std::numbers::pi : 0.0;
    const double angle = typed_angle(typed_for(gesture)).value_or(rounded_angle(gesture, dragged));
    Transformation made;
    made.typed_for = TypedFor::angle;
    made.reading = sentence("{angle}°", {{"angle", number_text(angle)}});
    if (angle == 0.0 || !std::isfinite(angle)) return made;
    made.map = core::rotation(angle, box.pivot);
    made.command = Rotate{.angle = angle, .what = box.what, .pivot = box.pivot};
    return made;
}

/// The factor of a shear by an angle; exactly 1 for 45 degrees.
double shear_of_angle(double angle) {
    return quantity_function("tan")({0.0, angle}).plain;
}

Transformation sheared(const DraggingTransform& mode, const Gesture& gesture, const TransformBox& box) {
    constexpr double half_turn = 180.0;
    const bool is_along_y = mode.grip.x != 0;
    const core::Point pivot = anchor_of(box, mode.grip);
    const core::Point start = grip_point(box, mode.grip);
    const core::Point target = led_from(gesture, start, mode.press_px, box, false);
    const double across = is_along_y ? start.x - pivot.x : start.y - pivot.y;
    const double along = is_along_y ? target.y - start.y : target.x - start.x;
    double factor = across != 0.0 ? along / across : 0.0;
    double angle = std::atan(factor) * half_turn / std::numbers::pi;
    if (gesture.event.modifiers.ctrl) factor = shear_of_angle(angle = rounded_angle(gesture, angle));
    if (const auto typed = typed_angle(typed_for(gesture))) factor = shear_of_angle(angle = *typed);
    Transformation made;
    made.typed_for = TypedFor::angle;
    made.reading = sentence("{angle}°", {{"angle", number_text(angle)}});
    if (factor == 0.0 || !std::isfinite(factor) || std::abs(factor) > 1e6) return made;
    made.map = core::shearing(is_along_y ? 0.0 : factor, is_along_y ? factor : 0.0, pivot);
    made.command =
        Shear{.axis = is_along_y ? ShearAxis::y : ShearAxis::x, .factor = factor, .what = box.what, .pivot = pivot};
    return made;
}

/// The corner, middle of a side, middle, or control point that is nearest to where the drag began: that one snaps.
core::Point moved_point(const DraggingTransform& mode, const Gesture& gesture, const TransformBox& box) {
    const core::Curve* curve = committed_curve(gesture.state);
    const bool moves_point = mode.clicked && (box.is_of_active_curve() || gesture.state.selection.is_whole ||
                                              gesture.state.selection.contains_point(*mode.clicked));
    if (moves_point && *mode.clicked < curve->control_points().size()) return curve->control_points()[*mode.clicked];
    const core::Point press(render::world_from_screen(gesture.state.view.camera, mode.press_px));
    core::Point nearest = grip_point(box, {});
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y) {
            const core::Point point = grip_point(box, {GripKind::inside, x, y});
            if (core::distance(point, press) < core::distance(nearest, press)) nearest = point;
        }
    return nearest;
}

Transformation moved(const DraggingTransform& mode, const Gesture& gesture, const TransformBox& box) {
    const core::Point start = moved_point(mode, gesture, box);
    const core::Point target = dragged_position(gesture, start, mode.press_px, dragged_by(box));
    Transformation made;
    made.typed_for = TypedFor::place;
    if (target == start) return made;
    const core::Vector offset = exact_offset(start, target);
    made.map = core::translation(offset);
    made.command = Move{.offset = offset, .what = box.what};
    return made;
}

Transformation transformation(const DraggingTransform& mode, const Gesture& gesture, const TransformBox& box) {
    switch (mode.grip.kind) {
        case GripKind::scale:
            return scaled(mode, gesture, box);
        case GripKind::turn:
            return turned(mode, gesture, box);
        case GripKind::shear:
            return sheared(mode, gesture, box);
        case GripKind::inside:
        case GripKind::pivot:
            break;
    }
    return moved(mode, gesture, box);
}

/// What stands beside the pointer, and what typed numbers mean.
void tell(const Gesture& gesture, const Transformation& made) {
    if (gesture.place == nullptr || made.typed_for == TypedFor::place) return;
    if (!*gesture.place) *gesture.place = ShownPlace{world_at_pointer(gesture), std::nullopt, std::nullopt};
    (*gesture.place)->typed_for = made.typed_for;
    (*gesture.place)->reading = made.reading;
}

CanvasMode ask(DraggingTransform mode, const Gesture& gesture, const TransformBox& box, Phase phase) {
    const Transformation made = transformation(mode, gesture, box);
    mode.map = made.map;
    tell(gesture, made);
    if (!made.command)
        gesture.queue.cancel_preview();
    else
        request(gesture, phase, *made.command);
    if (phase == Phase::preview) return mode;
    // What was chosen to stay goes along with what is moved. A move that is refused showed nothing.
    if (box.has_own_pivot && mode.grip.kind == GripKind::inside && gesture.state.preview)
        gesture.queue.change(SetPivot{core::mapped(made.map, box.pivot)});
    return CanvasIdle{};
}

void click(const DraggingTransform& mode, const Gesture& gesture, const TransformBox& box) {
    if (mode.grip.kind == GripKind::pivot)
        gesture.queue.change(SetPivot{box.has_own_pivot ? std::nullopt : std::optional(box.pivot)});
    if (mode.clicked && gesture.state.selection.points != std::vector{*mode.clicked})
        gesture.queue.run(SelectPoints{.points = {*mode.clicked}});
}

CanvasMode give_up(const DraggingTransform& mode, const Gesture& gesture) {
    if (!mode.has_moved) return CanvasIdle{};
    if (mode.grip.kind == GripKind::pivot)
        gesture.queue.change(SetPivot{mode.before ? std::optional(mode.before->point) : std::nullopt});
    else
        gesture.queue.cancel_preview();
    return CanvasIdle{};
}

}  // namespace

CanvasMode begin_transform(const Gesture& gesture, TransformGrip grip, std::optional<std::size_t> clicked) {
    DraggingTransform mode{.grip = grip, .press_px = gesture.event.position_px, .clicked = clicked};
    // One that was chosen for another selection does not count.
    if (const auto box = transform_box(gesture.state); box && box->has_own_pivot) mode.before = gesture.state.pivot;
    return mode;
}

CanvasMode step(DraggingTransform mode, const Gesture& gesture) {
    if (is_escape(gesture)) return give_up(mode, gesture);
    if (!is_move(gesture) && !is_release(gesture)) return mode;
    const auto box = transform_box(gesture.state);
    if (!box) return CanvasIdle{};
    mode.has_moved =
        mode.has_moved || is_typed(gesture) || is_drag(gesture.state, mode.press_px, gesture.event.position_px);
    if (!mode.has_moved) {
        if (!is_release(gesture)) return mode;
        click(mode, gesture, *box);
        return CanvasIdle{};
    }
    if (mode.grip.kind != GripKind::pivot)
        return ask(mode, gesture, *box, is_release(gesture) ? Phase::commit : Phase::preview);
    gesture.queue.change(SetPivot{pointed_at(gesture)});
    return is_release(gesture) ? CanvasMode(CanvasIdle{}) : CanvasMode(mode);
}

}  // namespace batten::editor
