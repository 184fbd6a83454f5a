#include "app/editor/pointer/axis_pick.h"

#include <cmath>
#include <numbers>

#include "app/editor/commands/array_commands.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/commands/symmetry_commands.h"
#include "app/editor/commands/transform_commands.h"
#include "app/editor/pointer/point_drag.h"
#include "app/editor/state/selected_parts.h"

namespace batten::editor {
namespace {

constexpr double degrees_of_turn = 360.0;

/// Of more control points than this, with all copies, nothing is shown before a click.
constexpr std::size_t most_points_previewed = 20'000;

/// Of the line from `first` to `second`, from 0 up to but not 180; exact for level, upright and diagonal ones.
double angle_of_line(core::Point first, core::Point second) {
    constexpr double half_turn = 180.0;
    const core::Vector way = second - first;
    if (way.x == 0.0) return 90.0;
    if (way.y == 0.0) return 0.0;
    if (way.x == way.y) return 45.0;
    if (way.x == -way.y) return 135.0;
    const double angle = std::atan2(way.y, way.x) * half_turn / std::numbers::pi;
    return angle < 0.0 ? angle + half_turn : angle;
}

Command mirror_command(const EditorState& state, AxisUse use, core::Point first, double angle) {
    if (use == AxisUse::link_mirror)
        return LinkMirror{.center = first, .angle = angle, .is_smooth = state.axis_pick->is_smooth};
    const MapTarget what = selected_parts(state).empty() ? MapTarget::curve : MapTarget::selection;
    return Mirror{.angle = angle, .what = what, .pivot = first};
}

/// The curves of which copies or images are shown: the selected ones, but links are made of the active one alone.
std::vector<std::size_t> previewed_curves(const EditorState& state) {
    const AxisUse use = state.axis_pick->use;
    const bool is_of_selected = use == AxisUse::mirror || use == AxisUse::array_polar;
    return is_of_selected ? *suggest::curves_meant(state) : std::vector{state.history.present().active};
}

bool is_quick(const EditorState& state) {
    if (committed_curve(state) == nullptr) return false;
    const std::size_t count = control_point_count(state.history.present(), previewed_curves(state));
    return count * std::max<std::size_t>(state.axis_pick->count, 2) <= most_points_previewed;
}

core::Point clicked_place(const Gesture& gesture) {
    return pointed_at(gesture, gesture.state.axis_pick->first);
}

}  // namespace

std::optional<Command> axis_command(const EditorState& state, core::Point place) {
    const AxisPick& pick = *state.axis_pick;
    if (pick.use == AxisUse::link_rotation) return LinkRotation{.turns = pick.count, .center = place};
    if (pick.use == AxisUse::array_polar)
        return PolarArray{
            .count = pick.count, .center = place, .step = degrees_of_turn / static_cast<double>(pick.count)};
    if (!pick.first || *pick.first == place) return std::nullopt;
    return mirror_command(state, pick.use, *pick.first, angle_of_line(*pick.first, place));
}

void hover_axis(const Gesture& gesture) {
    const auto command = axis_command(gesture.state, clicked_place(gesture));
    if (command && is_quick(gesture.state))
        gesture.queue.preview(*command);
    else if (gesture.state.preview)
        gesture.queue.cancel_preview();
}

void take_axis_click_back(const Gesture& gesture) {
    if (gesture.state.preview) gesture.queue.cancel_preview();
    if (gesture.state.axis_pick->first)
        gesture.queue.change(SetAxisPoint{});
    else
        gesture.queue.change(EndAxisPick{});
}

void click_axis(const Gesture& gesture) {
    const core::Point place = clicked_place(gesture);
    const AxisPick& pick = *gesture.state.axis_pick;
    if (needs_axis(pick.use) && !pick.first) {
        gesture.queue.change(SetAxisPoint{place});
        return;
    }
    const auto command = axis_command(gesture.state, place);
    if (!command) {
        gesture.queue.change(ShowRefusal{"an axis leads through two points; click another one than the first"});
        return;
    }
    gesture.queue.run(*command);
    gesture.queue.change(EndAxisPick{});
}

}  // namespace batten::editor
