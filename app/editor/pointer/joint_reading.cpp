#include "app/editor/pointer/joint_reading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/editor/commands/joint_report.h"
#include "app/editor/pointer/joint_command.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/length.h"
#include "core/base/sentence.h"
#include "core/refine/blend.h"
#include "core/refine/match.h"

namespace batten::editor {

namespace {

std::string jump_row(const char* pattern, const std::optional<double>& before, const std::optional<double>& after) {
    const auto text = [](const std::optional<double>& value) { return value ? number_text(*value) : "–"; };
    return core::filled_as_needed(pattern, {{"before", text(before)}, {"after", text(after)}});
}

// Both sides, then what the meeting is called.
std::vector<std::string> rows_of(const core::Meeting& found, const core::Box& box, const Units& units) {
    constexpr double degrees = 180.0 / std::numbers::pi;
    const int level = core::smoothness_of(found, core::robust_length(box.size()));
    const core::Meeting meeting = in_units(units, without_noise(found, box));
    return {core::filled_as_needed(level < 0 ? "gap {gap}, turn {angle}°" : "{level}: gap {gap}, turn {angle}°",
                                   {{"level", level_text(level)},
                                    {"gap", with_unit(units, number_text(meeting.gap))},
                                    {"angle", number_text(degrees * meeting.angle.value_or(0.0))}}),
            jump_row("curvature {before} and {after}", meeting.before, meeting.after),
            jump_row("its change {before} and {after}", meeting.change_before, meeting.change_after)};
}

// So many control points at an end decide what becomes of a joint there.
constexpr std::size_t points_at_end = 60;

// What of a long curve is beside an end.
core::Curve part_at_end(const core::Curve& curve, core::CurveEnd end) {
    const std::size_t n = curve.control_points().size();
    if (curve.is_periodic() || n <= points_at_end) return curve;
    const std::size_t first = end == core::CurveEnd::start ? 0 : n - points_at_end;
    const std::size_t knot_count = points_at_end + static_cast<std::size_t>(curve.degree()) + 1;
    const auto points = curve.control_points().subspan(first, points_at_end);
    const auto weights = curve.weights().subspan(first, points_at_end);
    const auto knots = curve.knots().stored().subspan(first, knot_count);
    auto part = core::Curve::make({.degree = curve.degree(),
                                   .knots = {knots.begin(), knots.end()},
                                   .points = {points.begin(), points.end()},
                                   .weights = {weights.begin(), weights.end()},
                                   .tears = core::Tears::allow});
    return part ? *std::move(part) : curve;
}

// The two ends that were picked.
struct PickedEnds {
    core::Curve first;
    core::Curve second;
    core::JoinedEnds ends;
    core::Passing from;  // beyond the first one
    core::Passing to;    // and into the other curve
};

PickedEnds ends_of(const EditorState& state, const PickingJoint& mode) {
    const auto& curves = state.history.present().curves;
    const core::Curve& first = *curves[mode.first->curve].curve;
    const core::Curve& second = *curves[mode.hovered->curve].curve;
    const core::JoinedEnds ends{mode.first->end, mode.hovered->end};
    const bool is_match = state.view.joint.operation == JointOperation::match;
    const core::Passing other =
        is_match ? core::passing_toward(second, match_parameter(state, *mode.hovered), first, ends.first)
                 : core::passing_beyond(second, ends.second);
    return {part_at_end(first, ends.first), part_at_end(second, ends.second), ends,
            core::passing_beyond(first, ends.first), core::run_back(other)};
}

core::Box box_of_both(const EditorState& state, const PickingJoint& mode) {
    const auto& curves = state.history.present().curves;
    core::Box box = state.derived.of(*curves[mode.first->curve].curve)->control_box;
    const core::Box other = state.derived.of(*curves[mode.hovered->curve].curve)->control_box;
    box.include(other.lower);
    box.include(other.upper);
    return box;
}

// The meetings that there would be: two of a blend, one of the others, none where it is refused.
std::vector<core::Meeting> meetings_after(const JointTool& tool, const PickedEnds& picked) {
    if (tool.operation == JointOperation::match) {
        const auto matched = core::match(picked.first, picked.ends.first, core::run_back(picked.to), tool.continuity);
        if (!matched) return {};
        return {change_of(*matched).after};
    }
    if (tool.operation == JointOperation::join) {
        const auto joined = core::join(picked.first, picked.second, as_join(tool.continuity), picked.ends);
        if (!joined) return {};
        return {change_of(*joined).after};
    }
    const core::BlendSide side{tool.continuity, 1.0};
    const auto blended = core::blend(picked.from, side, picked.to, side);
    if (!blended) return {};
    return {core::meeting_of(picked.from, core::passing_at(*blended, core::CurveEnd::start)),
            core::meeting_of(core::passing_at(*blended, core::CurveEnd::end), picked.to)};
}

}  // namespace

std::vector<std::string> joint_reading(const EditorState& state, const PickingJoint& mode) {
    if (mode.drag || !takes_ends(state.view.joint.operation) || !joint_command(state, mode)) return {};
    const PickedEnds picked = ends_of(state, mode);
    const core::Box box = box_of_both(state, mode);
    const Units& units = state.shown().units;
    std::vector<std::string> rows = rows_of(core::meeting_of(picked.from, picked.to), box, units);
    const std::vector<core::Meeting> meetings = meetings_after(state.view.joint, picked);
    for (std::size_t i = 0; i < meetings.size(); ++i) {
        const std::vector<std::string> told = rows_of(meetings[i], box, units);
        const char* pattern = meetings.size() == 1 ? "then {row}" : i == 0 ? "first end {row}" : "other end {row}";
        for (const std::string& row : told)
            rows.push_back(core::filled_as_needed(&row == &told.front() ? pattern : "then {row}", {{"row", row}}));
    }
    return rows;
}

}  // namespace batten::editor
