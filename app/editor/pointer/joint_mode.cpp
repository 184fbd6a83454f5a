#include "app/editor/pointer/joint_mode.h"

#include <utility>

#include "app/editor/commands/joint_tool_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/commands/trim_commands.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/joint_command.h"
#include "app/editor/pointer/joint_drag.h"
#include "app/editor/pointer/modes.h"
#include "app/editor/pointer/nearest.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {
namespace {

constexpr double pick_reach = 16.0;  ///< design pixels
constexpr double end_reach = 24.0;   ///< nearer to an end, that is meant and no place between

/// Of more control points than this only what jumps is told before a click, not shown what would come of it.
constexpr std::size_t most_points_shown = 2000;

core::CurveEnd nearer_end(const core::Curve& curve, core::Point place) {
    const auto away = [&](core::CurveEnd end) {
        return core::distance(core::point_at(curve, core::parameter_of(curve.domain(), end)), place);
    };
    return away(core::CurveEnd::start) < away(core::CurveEnd::end) ? core::CurveEnd::start : core::CurveEnd::end;
}

/// Which place of the curve is marked: the end, where the operation is about one or the pointer is near it.
core::Point marked_point(const Gesture& gesture, const core::Curve& curve, core::CurveEnd end,
                         const core::CurveSample& sample, bool is_first) {
    const JointOperation operation = gesture.state.view.joint.operation;
    const core::Point tip = core::point_at(curve, core::parameter_of(curve.domain(), end));
    const bool is_any_place = operation == JointOperation::match && !is_first;
    const bool is_end = takes_ends(operation) || (operation == JointOperation::extend && is_first);
    if (!is_end) return sample.point;
    if (!is_any_place) return tip;
    const double reach = pixels(gesture.state, end_reach) / gesture.state.view.camera.scale;
    return core::distance(tip, sample.point) <= reach ? tip : sample.point;
}

/// The place nearest to the pointer of all curves that are seen, within reach.
std::optional<PickedCurvePlace> picked_place(const Gesture& gesture, bool is_first) {
    const auto& curves = gesture.state.history.present().curves;
    const core::Point pointer = world_at_pointer(gesture);
    Nearest<PickedCurvePlace> nearest(pixels(gesture.state, pick_reach) / gesture.state.view.camera.scale);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (!curves[i].visible) continue;
        const auto sample = gesture.state.derived.near_parts(curves[i].curve)->nearest(pointer, nearest.distance());
        if (!sample) continue;
        const core::Curve& curve = *curves[i].curve;
        const core::CurveEnd end = nearer_end(curve, pointer);
        nearest.offer({i, sample->u, end, marked_point(gesture, curve, end, *sample, is_first), curves[i].curve},
                      core::distance(sample->point, pointer));
    }
    return nearest.found();
}

/// Whether the curves that an operation looks at are so short that what a click would do can be shown with every move:
/// those of both ends, else all.
bool is_quick(const Gesture& gesture, const PickingJoint& mode) {
    const auto& curves = gesture.state.history.present().curves;
    const auto is_meant = [&](std::size_t i) {
        return !takes_ends(gesture.state.view.joint.operation) || (mode.first && mode.first->curve == i) ||
               (mode.hovered && mode.hovered->curve == i);
    };
    std::size_t count = 0;
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (is_meant(i)) count += curves[i].curve->control_points().size();
    return count <= most_points_shown;
}

std::optional<core::Interval> part_to_trim(const Gesture& gesture, const PickingJoint& mode) {
    const std::optional<PickedCurvePlace>& place = mode.hovered;
    if (gesture.state.view.joint.operation != JointOperation::trim || !place || !is_quick(gesture, mode))
        return std::nullopt;
    const auto part = trimmed_part(gesture.state, place->curve, place->u);
    return part ? std::optional(*part) : std::nullopt;
}

void activate(const Gesture& gesture, std::size_t index) {
    if (gesture.state.history.present().active != index) gesture.queue.run(ActivateCurve{.index = index});
}

CanvasMode hover(PickingJoint mode, const Gesture& gesture) {
    mode.hovered = picked_place(gesture, !mode.first);
    mode.part = part_to_trim(gesture, mode);
    const auto command = is_quick(gesture, mode) ? joint_command(gesture.state, mode) : std::nullopt;
    if (command)
        gesture.queue.preview(*command);
    else if (gesture.state.preview)
        gesture.queue.cancel_preview();
    return mode;
}

CanvasMode click(PickingJoint mode, const Gesture& gesture) {
    mode.hovered = picked_place(gesture, !mode.first);
    if (!mode.hovered) return mode;
    const JointOperation operation = gesture.state.view.joint.operation;
    if (takes_one_click(operation)) {
        activate(gesture, mode.hovered->curve);
        gesture.queue.run(command_at(operation, mode.hovered->u));
        return PickingJoint{.tool_changes = mode.tool_changes};
    }
    if (!mode.first) {
        mode.drag = begin_joint_drag(gesture, *mode.hovered);
        activate(gesture, mode.hovered->curve);
        mode.first = mode.hovered;
        return mode;
    }
    const auto command = joint_command(gesture.state, mode);
    if (!command) return mode;
    gesture.queue.run(*command);
    return PickingJoint{.tool_changes = mode.tool_changes};
}

CanvasMode drag(PickingJoint mode, const Gesture& gesture) {
    const bool has_moved = mode.drag->distance != 0.0 || is_typed(gesture) ||
                           is_drag(gesture.state, mode.drag->press_px, gesture.event.position_px);
    if (!has_moved) return mode;
    mode.drag = dragged_joint(gesture, *mode.first, *mode.drag);
    if (mode.drag->distance != 0.0 && is_quick(gesture, mode))
        gesture.queue.preview(command_of_drag(gesture.state, *mode.first, *mode.drag));
    return mode;
}

/// A press that dragged nothing out is a click.
CanvasMode end_drag(PickingJoint mode, const Gesture& gesture) {
    mode = std::get<PickingJoint>(drag(std::move(mode), gesture));
    const JointDrag drag = *std::exchange(mode.drag, std::nullopt);
    if (drag.distance != 0.0) {
        gesture.queue.cancel_preview();
        gesture.queue.run(command_of_drag(gesture.state, *mode.first, drag));
        return PickingJoint{.tool_changes = mode.tool_changes};
    }
    if (!takes_two_places(gesture.state.view.joint.operation)) mode.first.reset();
    return mode;
}

CanvasMode go_back(PickingJoint mode, const Gesture& gesture) {
    if (!mode.first) {
        gesture.queue.run(SetTool{.tool = Tool::select});
        return CanvasIdle{};
    }
    gesture.queue.cancel_preview();
    mode.first.reset();
    mode.drag.reset();
    return mode;
}

/// Where the tool has nothing to do; a place that was picked waits.
CanvasMode aside(PickingJoint mode, const Gesture& gesture) {
    if (gesture.state.preview) gesture.queue.cancel_preview();
    if (!mode.first) return step_mode(CanvasIdle{}, gesture);
    mode.hovered.reset();
    mode.part.reset();
    return mode;
}

}  // namespace

CanvasMode begin_joint(const Gesture& gesture) {
    return step(PickingJoint{.tool_changes = gesture.state.tool_changes}, gesture);
}

void drop_gone_places(PickingJoint& mode, const EditorState& state) {
    const auto& curves = state.history.present().curves;
    const auto is_gone = [&](const std::optional<PickedCurvePlace>& place) {
        return place && (place->curve >= curves.size() || curves[place->curve].curve != place->shape);
    };
    if (is_gone(mode.hovered)) {
        mode.hovered.reset();
        mode.part.reset();
    }
    if (mode.drag && (is_gone(mode.first) || is_gone(mode.drag->other))) mode.drag.reset();
    if (is_gone(mode.first)) mode.first.reset();
}

std::optional<core::GeometricContinuity> continuity_of_key(const PointerEvent& event) {
    if (event.modifiers.ctrl || event.modifiers.alt) return std::nullopt;
    const auto digit = event.character != 0 ? static_cast<int>(event.character) - static_cast<int>(U'0')
                                            : static_cast<int>(event.key) - static_cast<int>(Key::digit_0);
    if (digit < 0 || digit >= static_cast<int>(joint_continuity_count)) return std::nullopt;
    return static_cast<core::GeometricContinuity>(digit);
}

CanvasMode step(PickingJoint mode, const Gesture& gesture) {
    if (step_pan(mode.panned_px, gesture)) return mode;
    // A ruler or an inset under the pointer, or an axis that is clicked, is no matter of the tool.
    if ((is_move(gesture) || is_press(gesture)) && !mode.drag && !is_about_tool(gesture)) return aside(mode, gesture);
    switch (gesture.event.action) {
        case PointerAction::move:
            return mode.drag ? drag(std::move(mode), gesture) : hover(std::move(mode), gesture);
        case PointerAction::press:
        case PointerAction::double_click:
            return gesture.event.button == PointerButton::left && !mode.drag ? click(std::move(mode), gesture)
                                                                             : CanvasMode(mode);
        case PointerAction::escape:
            return go_back(std::move(mode), gesture);
        case PointerAction::take_back:
            return mode.first ? go_back(std::move(mode), gesture) : CanvasMode(mode);
        case PointerAction::wheel:
            turn_canvas_wheel(gesture);
            return mode;
        case PointerAction::key:
            if (const auto continuity = continuity_of_key(gesture.event); continuity && !mode.drag)
                gesture.queue.run(SetJointContinuity{.continuity = *continuity});
            return mode;
        case PointerAction::leave:
            mode.hovered.reset();
            mode.part.reset();
            if (mode.first && !mode.drag) gesture.queue.cancel_preview();
            return mode;
        case PointerAction::release:
            if (mode.drag && is_release(gesture)) return end_drag(std::move(mode), gesture);
            break;
        case PointerAction::finish:
            break;
    }
    return mode;
}

}  // namespace batten::editor
