#include "app/editor/pointer/joint_command.h"

#include <cmath>
#include <numbers>

#include "app/editor/commands/corner_commands.h"
#include "app/editor/commands/joint_commands.h"
#include "app/editor/commands/joint_report.h"
#include "app/editor/commands/piece_commands.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/commands/trim_commands.h"
#include "app/editor/words/formula.h"
#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/meeting.h"
#include "core/refine/match.h"

namespace batten::editor {

namespace {

using core::sentence;

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

const core::Curve& curve_of(const EditorState& state, const PickedCurvePlace& place) {
    return *state.history.present().curves[place.curve].curve;
}

// The parameter of a match: that of an end where one was meant.
double match_parameter(const EditorState& state, const PickedCurvePlace& place) {
    const core::Curve& curve = curve_of(state, place);
    const double end = core::parameter_of(curve.domain(), place.end);
    return core::distance(core::point_at(curve, end), place.point) == 0.0 ? end : place.u;
}

Command corner_command(const EditorState& state, const PickingJoint& mode, const std::optional<std::string>& other) {
    const double radius = state.view.joint.radius.value_or(suggest::grid_step(state));
    if (state.view.joint.operation == JointOperation::fillet)
        return Fillet{.radius = radius, .u = mode.first->u, .other = other, .other_u = mode.hovered->u};
    return Chamfer{
        .distance = radius, .other_distance = radius, .u = mode.first->u, .other = other, .other_u = mode.hovered->u};
}

std::string jump_row(const char* pattern, const std::optional<double>& before, const std::optional<double>& after,
                     double noise) {
    const auto text = [&](const std::optional<double>& value) {
        return !value ? std::string("–") : number_text(std::abs(*value) <= noise ? 0.0 : *value);
    };
    return core::filled_as_needed(pattern, {{"before", text(before)}, {"after", text(after)}});
}

// Both sides, then what the meeting is called.
std::vector<std::string> rows_of(const core::Meeting& meeting, double size) {
    constexpr double degrees = 180.0 / std::numbers::pi;
    const double angle = meeting.angle ? std::abs(*meeting.angle) * degrees : 0.0;
    return {sentence("{level}: gap {gap}, turn {angle}°", {{"level", level_text(core::smoothness_of(meeting, size))},
                                                           {"gap", number_text(meeting.gap)},
                                                           {"angle", number_text(angle < 1e-7 ? 0.0 : angle)}}),
            jump_row("curvature {before} and {after}", meeting.before, meeting.after,
                     std::max(meeting.curvature_noise, 1e-12 / size)),
            jump_row("its change {before} and {after}", meeting.change_before, meeting.change_after,
                     std::max(meeting.change_noise, 1e-12 / size / size))};
}

}  // namespace

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

std::vector<std::string> joint_reading(const EditorState& state, const PickingJoint& mode) {
    if (!takes_ends(state.view.joint.operation) || !joint_command(state, mode)) return {};
    const core::Curve& first = curve_of(state, *mode.first);
    const core::Curve& second = curve_of(state, *mode.hovered);
    core::Box box = core::control_box(first);
    const core::Box other = core::control_box(second);
    box.include(other.lower);
    box.include(other.upper);
    const double size = core::robust_length(box.size());
    const core::Passing from = core::passing_beyond(first, mode.first->end);
    if (state.view.joint.operation != JointOperation::match)
        return rows_of(core::meeting_of(from, core::run_back(core::passing_beyond(second, mode.hovered->end))), size);
    const core::Passing target =
        core::run_back(core::passing_toward(second, match_parameter(state, *mode.hovered), first, mode.first->end));
    std::vector<std::string> rows = rows_of(core::meeting_of(from, target), size);
    if (!state.preview || state.preview->active_curve() == nullptr) return rows;
    const core::Curve& matched = *state.preview->active_curve()->curve;
    for (std::string& row : rows_of(core::meeting_of(core::passing_beyond(matched, mode.first->end), target), size))
        rows.push_back(sentence("then {row}", {{"row", row}}));
    return rows;
}

std::string joint_hint(const EditorState& state, const PickingJoint& mode) {
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
                       : "Click one side of a corner, where it shall stay";
        case JointOperation::chamfer:
            return mode.first ? "Click the other side of the corner · the menu of the tool sets the distance · Escape "
                                "goes back"
                              : "Click one side of a corner, where it shall stay";
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
