#include "app/editor/pointer/fit_point_drag.h"

#include <algorithm>

#include "app/editor/commands/fit_point_commands.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/point_drag.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {
namespace {

// More handles than this would not be seen, and to look for them takes time.
constexpr std::size_t most_handles_searched = 2000;

void select_only(const Gesture& gesture, std::size_t index) {
    if (gesture.state.selection.fit_point != index) gesture.queue.run(SelectFitPoint{.index = index});
}

void ask_to_move(const DraggingFitPoint& mode, const Gesture& gesture, Phase phase) {
    const core::FitPoints* fit = committed_fit(gesture.state);
    if (fit == nullptr || mode.index > fit->points.size() - (mode.is_new ? 0 : 1)) return;
    const core::Point target = dragged_position(gesture, mode.start, mode.press_px, {.is_curve = true});
    if (mode.is_new)
        request(gesture, phase, InsertFitPoint{.index = mode.index, .position = target});
    else if (target == mode.start)
        gesture.queue.cancel_preview();
    else
        request(gesture, phase, MoveFitPoint{.index = mode.index, .position = target});
}

void ask_to_turn(const DraggingFitHandle& mode, const Gesture& gesture, Phase phase) {
    const core::FitPoints* fit = committed_fit(gesture.state);
    if (fit == nullptr || mode.index >= fit->points.size()) return;
    const core::Point center = fit->points[mode.index].place;
    const core::Point target = dragged_position(gesture, mode.start, mode.press_px, {.is_curve = true, .from = center});
    const core::Vector arm = target - center;
    const core::Vector handle = mode.end == HandleEnd::ahead ? arm : -arm;
    if (target == mode.start || handle == core::Vector(0.0, 0.0))
        gesture.queue.cancel_preview();
    else
        request(gesture, phase, SetFitJoint{.index = mode.index, .joint = core::FitJoint::tangent, .handle = handle});
}

}  // namespace

const core::FitPoints* committed_fit(const EditorState& state) {
    const core::DocumentCurve* active = state.history.present().active_curve();
    return active == nullptr ? nullptr : active->fit.get();
}

core::Point handle_tip(const core::FitPoints& fit, std::size_t i, HandleEnd end) {
    const core::FitPoint& point = fit.points[i];
    return end == HandleEnd::ahead ? point.place + point.handle : point.place - point.handle;
}

std::vector<std::size_t> points_with_handles(const core::FitPoints& fit, const Selection& selection) {
    std::vector<std::size_t> found;
    const auto offer = [&](std::size_t i) {
        if (i < fit.points.size() && fit.points[i].joint == core::FitJoint::tangent) found.push_back(i);
    };
    if (fit.points.size() <= most_handles_searched)
        for (std::size_t i = 0; i < fit.points.size(); ++i) offer(i);
    else if (selection.fit_point)
        offer(*selection.fit_point);
    return found;
}

std::size_t index_of_new_point(const core::FitPoints& fit, double u) {
    const auto above = std::ranges::upper_bound(fit.parameters, u);
    const auto index = static_cast<std::size_t>(above - fit.parameters.begin());
    return std::clamp<std::size_t>(index, 1, fit.parameters.size() - 1);
}

std::optional<std::size_t> fit_point_at(const core::FitPoints& fit, double u) {
    const auto found = std::ranges::lower_bound(fit.parameters, u);
    if (found == fit.parameters.end() || *found != u) return std::nullopt;
    return static_cast<std::size_t>(found - fit.parameters.begin()) % fit.points.size();
}

CanvasMode begin_fit_point_drag(const Gesture& gesture, std::size_t index) {
    const core::FitPoints* fit = committed_fit(gesture.state);
    if (fit == nullptr || index >= fit->points.size()) return CanvasIdle{};
    if (!can_edit_curve(gesture.state)) return CanvasIdle{};
    select_only(gesture, index);
    return DraggingFitPoint{index, fit->points[index].place, gesture.event.position_px};
}

CanvasMode begin_fit_handle_drag(const Gesture& gesture, const HoveredFitHandle& hit) {
    const core::FitPoints* fit = committed_fit(gesture.state);
    if (fit == nullptr || hit.index >= fit->points.size() || !can_edit_curve(gesture.state)) return CanvasIdle{};
    select_only(gesture, hit.index);
    return DraggingFitHandle{hit.index, hit.end, handle_tip(*fit, hit.index, hit.end), gesture.event.position_px};
}

CanvasMode begin_new_fit_point(const Gesture& gesture, double u) {
    const core::FitPoints& fit = *committed_fit(gesture.state);
    const core::Point start = core::point_at(*committed_curve(gesture.state), u);
    return DraggingFitPoint{index_of_new_point(fit, u), start, gesture.event.position_px, true};
}

void insert_fit_point_at(const Gesture& gesture, double u) {
    const core::Point place = core::point_at(*committed_curve(gesture.state), u);
    gesture.queue.run(InsertFitPoint{.index = index_of_new_point(*committed_fit(gesture.state), u), .position = place});
}

void turn_fit_joint(const Gesture& gesture, std::size_t index) {
    const bool is_smooth = committed_fit(gesture.state)->points[index].joint == core::FitJoint::smooth;
    gesture.queue.run(
        SetFitJoint{.index = index, .joint = is_smooth ? core::FitJoint::corner : core::FitJoint::smooth});
}

CanvasMode step_fit_point_drag(const DraggingFitPoint& mode, const Gesture& gesture) {
    return step_edit(mode, gesture, ask_to_move, [](const auto&, const Gesture&) {});
}

CanvasMode step_fit_handle_drag(const DraggingFitHandle& mode, const Gesture& gesture) {
    return step_edit(mode, gesture, ask_to_turn, [](const auto&, const Gesture&) {});
}

}  // namespace batten::editor
