#include "app/editor/commands/snap_commands.h"
#include "app/editor/commands/unit_commands.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/modes.h"
#include "app/editor/pointer/point_drag.h"
#include "app/editor/pointer/typed_place.h"
#include "app/editor/scene/ruler.h"

namespace batten::editor {
namespace {

bool is_over_ruler(const Gesture& gesture) {
    return !is_typed(gesture) && ruler_at(gesture.state, gesture.event.position_px).has_value();
}

/// Where the pointer puts a line of this angle; a number alone that is typed for a level or an upright one is its y or
/// x.
core::Point place_of_line(const Gesture& gesture, double angle, core::Point pointed) {
    const bool is_level = angle == 0.0;
    if (!is_level && angle != 90.0) return pointed;
    const auto number = typed_length_alone(typed_for(gesture), gesture.state.shown().units);
    if (number) (is_level ? pointed.y : pointed.x) = *number;
    if (gesture.place != nullptr && *gesture.place) {
        (*gesture.place)->typed_for = is_level ? TypedFor::y : TypedFor::x;
        if (number) (*gesture.place)->position = pointed;
    }
    return pointed;
}

void ask_to_move_guide(const DraggingGuide& mode, const Gesture& gesture, Phase phase) {
    const auto& guides = gesture.state.history.present().guides;
    if (mode.index >= guides.size()) return;
    if (is_over_ruler(gesture)) return request(gesture, phase, RemoveGuide{.index = mode.index});
    const core::Point start = guides[mode.index].point;
    const core::Point target = dragged_position(gesture, start, mode.press_px, {.guide = mode.index});
    if (target == start)
        gesture.queue.cancel_preview();
    else
        request(gesture, phase, MoveGuide{.index = mode.index, .position = target});
}

void ask_for_guide(const PullingGuide& mode, const Gesture& gesture, Phase phase) {
    if (is_over_ruler(gesture)) return gesture.queue.cancel_preview();
    const core::Point position = place_of_line(gesture, mode.angle, pointed_at(gesture));
    request(gesture, phase, AddGuide{.position = position, .angle = mode.angle});
}

}  // namespace

CanvasMode begin_guide_drag(const Gesture& gesture, std::size_t index) {
    return DraggingGuide{index, gesture.event.position_px};
}

CanvasMode begin_ruler_gesture(const Gesture& gesture) {
    const glm::dvec2 place = gesture.event.position_px;
    if (!is_in_ruler_corner(gesture.state, place))
        return PullingGuide{ruler_at(gesture.state, place) == RulerAxis::x ? 0.0 : 90.0, place};
    gesture.queue.change(ShowForm{&SetUnits::spec()});
    return CanvasIdle{};
}

CanvasMode step(const PullingGuide& mode, const Gesture& gesture) {
    return step_edit(mode, gesture, ask_for_guide, [](const auto&, const Gesture&) {});
}

CanvasMode step(const DraggingGuide& mode, const Gesture& gesture) {
    return step_edit(mode, gesture, ask_to_move_guide, [](const auto&, const Gesture&) {});
}

}  // namespace batten::editor
