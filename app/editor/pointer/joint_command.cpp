#include "app/editor/pointer/joint_command.h"

#include "app/editor/commands/corner_commands.h"
#include "app/editor/commands/joint_commands.h"
#include "app/editor/commands/piece_commands.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/commands/trim_commands.h"
#include "app/editor/pointer/joint_drag.h"
#include "core/base/sentence.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

const core::Curve& curve_of(const EditorState& state, const PickedCurvePlace& place) {
    return *state.history.present().curves[place.curve].curve;
}

Command corner_command(const EditorState& state, const PickingJoint& mode, const std::optional<std::string>& other) {
    const double radius = state.view.joint.radius.value_or(suggest::grid_step(state));
    if (state.view.joint.operation == JointOperation::fillet)
        return Fillet{.radius = radius, .u = mode.first->u, .other = other, .other_u = mode.hovered->u};
    return Chamfer{
        .distance = radius, .other_distance = radius, .u = mode.first->u, .other = other, .other_u = mode.hovered->u};
}

std::string drag_hint(const EditorState& state, const JointDrag& drag) {
    return core::sentence("{size} · drag or type it · Enter or release makes it · Escape goes back",
                          {{"size", size_words(state, drag)}});
}

}  // namespace

core::JoinContinuity as_join(core::GeometricContinuity continuity) {
    switch (continuity) {
        case core::GeometricContinuity::g0:
            return core::JoinContinuity::c0;
        case core::GeometricContinuity::g1:
            return core::JoinContinuity::g1;
        case core::GeometricContinuity::g2:
            return core::JoinContinuity::g2;
        case core::GeometricContinuity::g3:
            break;
    }
    return core::JoinContinuity::g3;
}

double match_parameter(const EditorState& state, const PickedCurvePlace& place) {
    const core::Curve& curve = curve_of(state, place);
    const double end = core::parameter_of(curve.domain(), place.end);
    return core::distance(core::point_at(curve, end), place.point) == 0.0 ? end : place.u;
}

Command command_at(JointOperation operation, double u) {
    if (operation == JointOperation::trim) return Trim{.u = u};
    return SplitAtCrossings{.scope = SplitScope::active};
}

std::optional<Command> joint_command(const EditorState& state, const PickingJoint& mode) {
    const core::Document& document = state.history.present();
    if (!mode.first || !mode.hovered || mode.first->curve >= document.curves.size() ||
        mode.hovered->curve >= document.curves.size())
        return std::nullopt;
    const JointTool& tool = state.view.joint;
    const bool is_one = mode.first->curve == mode.hovered->curve;
    const std::string& other = document.curves[mode.hovered->curve].name;
    if (tool.operation == JointOperation::fillet || tool.operation == JointOperation::chamfer)
        return corner_command(state, mode, is_one ? std::nullopt : std::optional(other));
    if (is_one) return std::nullopt;
    switch (tool.operation) {
        case JointOperation::join:
            return Join{.other = other,
                        .continuity = as_join(tool.continuity),
                        .end = mode.first->end,
                        .other_end = mode.hovered->end};
        case JointOperation::match:
            return Match{.other = other,
                         .continuity = tool.continuity,
                         .end = mode.first->end,
                         .at = match_parameter(state, *mode.hovered)};
        case JointOperation::blend:
            return Blend{.other = other,
                         .continuity = tool.continuity,
                         .other_continuity = tool.continuity,
                         .end = mode.first->end,
                         .other_end = mode.hovered->end,
                         .tension = 1.0,
                         .other_tension = 1.0};
        case JointOperation::extend:
            return ExtendTo{.other = other, .end = mode.first->end, .onward = core::Onward::natural};
        default:
            return std::nullopt;
    }
}

std::string joint_hint(const EditorState& state, const PickingJoint& mode) {
    if (mode.drag) return drag_hint(state, *mode.drag);
    switch (state.view.joint.operation) {
        case JointOperation::join:
            return mode.first
                       ? "Click the end that shall move to meet it · 0 to 3 choose the continuity · Escape goes back"
                       : "Click the end that stays where it is · 0 to 3 choose the continuity";
        case JointOperation::match:
            return mode.first
                       ? "Click where it shall meet the other curve · 0 to 3 choose the continuity · Escape goes back"
                       : "Click the end that shall change · 0 to 3 choose the continuity";
        case JointOperation::blend:
            return mode.first
                       ? "Click the end where the new curve arrives · 0 to 3 choose the continuity · Escape goes back"
                       : "Click the end where the new curve begins · 0 to 3 choose the continuity";
        case JointOperation::fillet:
            return mode.first
                       ? "Click the other side of the corner · the menu of the tool sets the radius · Escape goes back"
                       : "Drag the radius out of a corner · or click one side of it, where it shall stay";
        case JointOperation::chamfer:
            return mode.first ? "Click the other side of the corner · the menu of the tool sets the distance · Escape "
                                "goes back"
                              : "Drag the distance out of a corner · or click one side of it, where it shall stay";
        case JointOperation::offset:
            return "Drag an offset out of a curve · the menu of the tool chooses sides, corners and caps";
        case JointOperation::trim:
            return "Click the part that goes, up to the next crossings · Escape leaves the tool";
        case JointOperation::extend:
            return mode.first ? "Click the curve that it shall reach · Escape goes back" : "Click the end that grows";
        case JointOperation::split:
            break;
    }
    return "Click a curve to cut it where others cross it · Escape leaves the tool";
}

}  // namespace batten::editor
