#include <algorithm>
#include <cmath>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;

constexpr double seconds_for_domain = 5.0;  // at speed 1
constexpr double least_speed = 0.01;
constexpr double most_speed = 20.0;
constexpr int steps_in_domain = 100;

core::Interval shown_domain(const EditorState& state) {
    return state.active_curve()->domain();
}

Outcome<void> set_parameter(EditorState& state, const Arguments& arguments) {
    state.view.parameter = state.active_curve()->knots().into_domain(arguments.number(0));
    return {};
}

template <int direction>
Outcome<void> step_parameter(EditorState& state, const Arguments&) {
    const core::Interval domain = shown_domain(state);
    state.view.parameter = domain.clamp(state.parameter() + direction * domain.length() / steps_in_domain);
    return {};
}

Outcome<void> toggle_play(EditorState& state, const Arguments&) {
    state.view.playback.is_playing = !state.view.playback.is_playing;
    return {};
}

Outcome<void> toggle_ping_pong(EditorState& state, const Arguments&) {
    state.view.playback.ping_pong = !state.view.playback.ping_pong;
    state.view.playback.direction = 1;
    return {};
}

Outcome<void> set_speed(EditorState& state, const Arguments& arguments) {
    const double speed = arguments.number(0);
    if (speed < least_speed || speed > most_speed)
        return tl::unexpected("the speed is " + number_text(speed) + "; it must be from " + number_text(least_speed) +
                              " to " + number_text(most_speed));
    state.view.playback.speed = speed;
    return {};
}

// A share of the domain, 0..1, with the direction in which it moves on.
struct Position {
    double share = 0.0;
    int direction = 1;
};

// Unfolds the way to and fro into one way of length 2, on which the place is found by a remainder.
Position turned(Position from, double way) {
    const double start = from.direction > 0 ? from.share : 2.0 - from.share;
    const double end = std::fmod(start + way, 2.0);
    return end < 1.0 ? Position{end, 1} : Position{2.0 - end, -1};
}

Position wrapped(Position from, double way) {
    const double end = from.share + way;
    return {end <= 1.0 ? end : std::fmod(end, 1.0), 1};
}

Outcome<void> advance(EditorState& state, const Arguments& arguments) {
    if (arguments.number(0) < 0.0) return tl::unexpected(Refusal("the time to advance by must not be negative"));
    Playback& playback = state.view.playback;
    if (!playback.is_playing) return {};
    const core::Interval domain = shown_domain(state);
    const double way = playback.speed * arguments.number(0) / seconds_for_domain;
    // Not into_domain: at the end of a closed curve that would be the start, which cannot be turned at.
    const Position from{(domain.clamp(state.view.parameter) - domain.lower) / domain.length(), playback.direction};
    const Position to = playback.ping_pong ? turned(from, way) : wrapped(from, way);
    state.view.parameter = domain.clamp(domain.lower + to.share * domain.length());
    playback.direction = to.direction;
    return {};
}

Outcome<void> set_level(EditorState& state, const Arguments& arguments) {
    if (arguments.number(0) == -1.0) {
        state.view.level.reset();
        return {};
    }
    const Outcome<std::size_t> level = index_of(arguments.number(0), "n");
    if (!level) return tl::unexpected(level.error());
    const int p = state.active_curve()->degree();
    if (*level > static_cast<std::size_t>(p))
        return tl::unexpected("there is no level " + std::to_string(*level) + "; the last one is " + std::to_string(p));
    state.view.level = static_cast<int>(*level);
    return {};
}

// The last level is the same picture as all levels.
template <int step>
Outcome<void> step_level(EditorState& state, const Arguments&) {
    const int p = state.active_curve()->degree();
    const int level = std::clamp(state.view.level.value_or(p) + step, 0, p);
    state.view.level = level == p ? std::nullopt : std::optional(level);
    return {};
}

void add_parameter(std::vector<CommandSpec>& table) {
    table.push_back({.name = "set-parameter",
                     .title = "Set parameter",
                     .explanation = "Moves u, where the construction is shown.",
                     .group = CommandGroup::construct,
                     .parameters = {{"u", Kind::number, "where in the domain"}},
                     .refusal = no_curve,
                     .act = set_parameter});
    table.push_back({.name = "step-parameter-back",
                     .title = "Step back",
                     .explanation = "Moves u back by a hundredth of the domain.",
                     .group = CommandGroup::construct,
                     .shortcut = {Key::comma, {}},
                     .refusal = no_curve,
                     .act = step_parameter<-1>});
    table.push_back({.name = "step-parameter-forward",
                     .title = "Step forward",
                     .explanation = "Moves u on by a hundredth of the domain.",
                     .group = CommandGroup::construct,
                     .shortcut = {Key::period, {}},
                     .refusal = no_curve,
                     .act = step_parameter<1>});
}

void add_playback(std::vector<CommandSpec>& table) {
    table.push_back({.name = "toggle-play",
                     .title = "Play",
                     .explanation = "Lets u run by itself, or stops it.",
                     .group = CommandGroup::construct,
                     .shortcut = {Key::p, {}},
                     .refusal = no_curve,
                     .is_checked = [](const EditorState& state) { return state.view.playback.is_playing; },
                     .act = toggle_play});
    table.push_back({.name = "toggle-ping-pong",
                     .title = "To and fro",
                     .explanation = "Lets the running u turn at the ends, or jump back to the start.",
                     .group = CommandGroup::construct,
                     .is_checked = [](const EditorState& state) { return state.view.playback.ping_pong; },
                     .act = toggle_ping_pong});
    table.push_back({.name = "set-speed",
                     .title = "Set speed",
                     .explanation = "Sets how fast u runs; at 1 it crosses the domain in five seconds.",
                     .group = CommandGroup::construct,
                     .parameters = {{"speed", Kind::number, "fifths of the domain per second, 0.01 to 20"}},
                     .act = set_speed});
    table.push_back({.name = "advance",
                     .title = "Advance",
                     .explanation = "Moves the running u on by the time that went by.",
                     .group = CommandGroup::gesture,
                     .parameters = {{"seconds", Kind::number, "the time that went by"}},
                     .refusal = no_curve,
                     .act = advance,
                     .is_logged = false});
}

void add_levels(std::vector<CommandSpec>& table) {
    table.push_back({.name = "set-level",
                     .title = "Set level",
                     .explanation = "Shows the construction up to a level.",
                     .group = CommandGroup::construct,
                     .parameters = {{"n", Kind::number, "the last level shown, or -1 for all"}},
                     .refusal = no_curve,
                     .act = set_level});
    table.push_back({.name = "previous-level",
                     .title = "Previous level",
                     .explanation = "Shows one level of the construction less.",
                     .group = CommandGroup::construct,
                     .shortcut = {Key::page_up, {}},
                     .refusal = no_curve,
                     .act = step_level<-1>});
    table.push_back({.name = "next-level",
                     .title = "Next level",
                     .explanation = "Shows one level of the construction more.",
                     .group = CommandGroup::construct,
                     .shortcut = {Key::page_down, {}},
                     .refusal = no_curve,
                     .act = step_level<1>});
}

}  // namespace

void add_construction_commands(std::vector<CommandSpec>& table) {
    add_parameter(table);
    add_playback(table);
    add_levels(table);
}

}  // namespace batten::editor
