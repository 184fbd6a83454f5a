#include "app/editor/pointer/handlebar.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/commands/shape_commands.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/nearest.h"
#include "app/editor/pointer/point_drag.h"
#include "core/edit/shape_edit.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {
namespace {

// Design pixels. An arm ends so far from its place and from the control point to which it leads.
constexpr double least_gap = 20.0;
constexpr double least_arm = 2.0 * least_gap;
constexpr double greatest_arm = 160.0;
constexpr double same_direction = 1e-6;

// Where a curve is looked at to see one side of a place.
struct Approach {
    double u;
    core::Side side;
};

// None beyond the end of an open curve.
std::optional<Approach> approach(const core::Curve& curve, double u, core::Side side) {
    const core::Interval domain = curve.domain();
    const double limit = side == core::Side::right ? domain.upper : domain.lower;
    if (curve.is_periodic() || u != limit) return Approach{u, side};
    const auto points = curve.control_points();
    const bool is_closed = points.front() == points.back();
    if (!is_closed) return std::nullopt;
    return Approach{side == core::Side::right ? domain.lower : domain.upper, side};
}

double length_of_span(const core::Curve& curve, const Approach& at) {
    const core::KnotVector& knots = curve.knots();
    const std::size_t span = knots.span_at(at.u, at.side);
    return knots[span + 1] - knots[span];
}

// Of an arm, beside a leg of the Bézier piece that is so long: half of it, or beyond it where that would be short.
double arm_length(double leg) {
    return leg >= least_arm ? std::min(leg / 2.0, greatest_arm) : std::max(least_arm, leg + least_gap);
}

double reach_of_arm(const EditorState& state, const Approach& at) {
    const core::Curve& curve = *committed_curve(state);
    const double reach = length_of_span(curve, at) / curve.degree();
    const double length_px =
        reach * core::length(core::derivatives_at(curve, at.u, 1, at.side)[1]) * state.view.camera.scale;
    const double leg = length_px / pixels(state, 1.0);
    const double scaled = leg > 0.0 ? arm_length(leg) / leg * reach : reach;
    return std::isfinite(scaled) ? scaled : reach;
}

std::optional<HandlebarArm> arm_of(const EditorState& state, const core::Curve& curve, double u, core::Side side) {
    const auto at = approach(curve, u, side);
    if (!at) return std::nullopt;
    const auto jet = core::derivatives_at(curve, at->u, 1, side);
    const double reach = (side == core::Side::right ? 1.0 : -1.0) * reach_of_arm(state, *at);
    const core::Point tip = jet.point + reach * jet[1];
    if (tip == jet.point || !core::is_finite(tip)) return std::nullopt;
    return HandlebarArm{at->u, side, reach, tip};
}

bool is_in_line(const core::Curve& curve, const HandlebarArm& ahead, const HandlebarArm& behind) {
    const core::Vector before = core::derivatives_at(curve, behind.u, 1, behind.side)[1];
    const core::Vector after = core::derivatives_at(curve, ahead.u, 1, ahead.side)[1];
    const double across = before.x * after.y - before.y * after.x;
    return core::dot(before, after) > 0.0 && std::abs(across) <= same_direction * core::dot(before, after);
}

// Whether the place can move while its tangent stays as it is.
bool can_keep_tangent(const EditorState& state, const Handlebar& bar) {
    if (bar.is_kinked) return false;
    const core::Curve& curve = *committed_curve(state);
    const auto jet = core::derivatives_at(curve, bar.u, 1);
    return core::move_curve_point_and_tangent(curve, bar.u, jet.point, jet[1], core::Side::right,
                                              state.history.present().active_curve()->pinned)
        .has_value();
}

void ask_to_move_middle(const DraggingHandlebar& mode, const Gesture& gesture, Phase phase) {
    const double u = *gesture.state.selection.handlebar;
    const core::Point target = dragged_position(gesture, mode.start, mode.press_px, {.is_curve = true});
    if (target == mode.start) return gesture.queue.cancel_preview();
    if (!mode.keeps_tangent) return request(gesture, phase, MoveCurvePoint{.u = u, .position = target});
    const core::Vector derivative = core::derivatives_at(*committed_curve(gesture.state), u, 1)[1];
    request(gesture, phase, MovePointAndTangent{.u = u, .position = target, .derivative = derivative});
}

void ask_to_move_arm(const DraggingHandlebar& mode, const Gesture& gesture, Phase phase) {
    const core::Curve& curve = *committed_curve(gesture.state);
    const Handlebar bar = handlebar_of(gesture.state, curve, *gesture.state.selection.handlebar);
    const auto& arm = mode.part == HandlebarPart::ahead ? bar.ahead : bar.behind;
    if (!arm) return;
    const core::Point base = core::point_at(curve, arm->u, arm->side);
    const core::Point target = dragged_tip(gesture, base, mode.start, mode.press_px, {.is_curve = true});
    if (target == mode.start) return gesture.queue.cancel_preview();
    request(gesture, phase, SetTangent{.u = arm->u, .derivative = (target - base) / arm->reach, .side = arm->side});
}

void ask_to_move_bar(const DraggingHandlebar& mode, const Gesture& gesture, Phase phase) {
    if (committed_curve(gesture.state) == nullptr || !gesture.state.selection.handlebar) return;
    if (mode.part == HandlebarPart::middle)
        ask_to_move_middle(mode, gesture, phase);
    else
        ask_to_move_arm(mode, gesture, phase);
}

}  // namespace

Handlebar handlebar_of(const EditorState& state, const core::Curve& curve, double u) {
    Handlebar bar{.u = u,
                  .place = core::point_at(curve, u),
                  .ahead = arm_of(state, curve, u, core::Side::right),
                  .behind = arm_of(state, curve, u, core::Side::left)};
    bar.is_kinked = bar.ahead && bar.behind && !is_in_line(curve, *bar.ahead, *bar.behind);
    return bar;
}

std::optional<double> parameter_at_point(const core::Curve& curve, std::size_t index) {
    const core::KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    if (index >= curve.control_points().size() || knots[index + 1] != knots[index + p]) return std::nullopt;
    return knots.into_domain(knots[index + 1]);
}

std::optional<Handlebar> shown_handlebar(const EditorState& state) {
    const core::Curve* curve = state.visible_active_curve();
    if (!state.selection.handlebar || curve == nullptr || state.tool != Tool::select) return std::nullopt;
    if (state.shown().active_curve()->fit != nullptr || committed_curve(state) == nullptr) return std::nullopt;
    if (!curve->domain().contains(*state.selection.handlebar)) return std::nullopt;
    return handlebar_of(state, *curve, *state.selection.handlebar);
}

std::optional<core::Point> place_of(const Handlebar& bar, HandlebarPart part) {
    if (part == HandlebarPart::middle) return bar.place;
    const auto& arm = part == HandlebarPart::ahead ? bar.ahead : bar.behind;
    return arm ? std::optional(arm->tip) : std::nullopt;
}

std::optional<HandlebarPart> handlebar_part_at(const EditorState& state, glm::dvec2 position_px, double reach_px) {
    const auto bar = shown_handlebar(state);
    if (!bar) return std::nullopt;
    Nearest<HandlebarPart> nearest(reach_px);
    for (const HandlebarPart part : {HandlebarPart::middle, HandlebarPart::ahead, HandlebarPart::behind})
        if (const auto place = place_of(*bar, part))
            nearest.offer(part, glm::distance(position_px, render::screen_from_world(state.view.camera, *place)));
    return nearest.found();
}

CanvasMode begin_handlebar_drag(const Gesture& gesture, HandlebarPart part) {
    const auto bar = shown_handlebar(gesture.state);
    const auto start = bar ? place_of(*bar, part) : std::nullopt;
    if (!start || !can_edit_curve(gesture.state)) return CanvasIdle{};
    return DraggingHandlebar{part, *start, gesture.event.position_px,
                             part == HandlebarPart::middle && can_keep_tangent(gesture.state, *bar)};
}

CanvasMode step(const DraggingHandlebar& mode, const Gesture& gesture) {
    return step_edit(mode, gesture, ask_to_move_bar, [](const auto&, const Gesture&) {});
}

}  // namespace batten::editor
