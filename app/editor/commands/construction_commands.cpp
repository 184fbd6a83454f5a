#include "app/editor/commands/construction_commands.h"

#include <algorithm>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/wording.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr double least_speed = 0.01;
constexpr double most_speed = 20.0;
constexpr int steps_in_domain = 100;

Outcome<void> set_parameter(EditorState& state, const SetParameter& command) {
    const core::KnotVector& knots = state.active_curve()->knots();
    state.view.parameter = knots.into_domain(command.u);
    if (!knots.domain().contains(command.u))
        state.message = {clamped_sentence(knots, command.u, state.view.parameter), false};
    return {};
}

template <class Command, int direction>
Outcome<void> step_parameter(EditorState& state, const Command&) {
    const core::Interval domain = state.active_curve()->domain();
    state.view.parameter = domain.clamp(state.parameter() + direction * domain.length() / steps_in_domain);
    return {};
}

Outcome<void> toggle_play(EditorState& state, const TogglePlay&) {
    state.view.playback.is_playing = !state.view.playback.is_playing;
    return {};
}

Outcome<void> toggle_ping_pong(EditorState& state, const TogglePingPong&) {
    state.view.playback.ping_pong = !state.view.playback.ping_pong;
    state.view.playback.direction = 1;
    return {};
}

Outcome<void> set_blossom_values(EditorState& state, const SetBlossomValues& command) {
    state.view.blossom_values = command.by_value;
    return {};
}

Outcome<void> set_speed(EditorState& state, const SetSpeed& command) {
    state.view.playback.speed = command.speed;
    return {};
}

Outcome<void> set_level(EditorState& state, const SetLevel& command) {
    const int p = active_curve(state).degree();
    if (command.level.value_or(0) > p)
        return tl::unexpected(core::sentence("there is no level {level}; the last one is {last}",
                                             {{"level", *command.level}, {"last", p}}));
    state.view.level = command.level;
    return {};
}

// The last level is the same picture as all levels.
template <class Command, int step>
Outcome<void> step_level(EditorState& state, const Command&) {
    const int p = active_curve(state).degree();
    const int level = std::clamp(state.view.level.value_or(p) + step, 0, p);
    state.view.level = level == p ? std::nullopt : std::optional(level);
    return {};
}

bool is_playing(const EditorState& state) {
    return state.view.playback.is_playing;
}

bool is_ping_pong(const EditorState& state) {
    return state.view.playback.ping_pong;
}

double current_parameter(const EditorState& state) {
    return state.parameter();
}

double current_speed(const EditorState& state) {
    return state.view.playback.speed;
}

std::optional<int> current_level(const EditorState& state) {
    return state.view.level;
}

}  // namespace

const CommandSpec& SetParameter::spec() {
    static const CommandSpec spec{
        .name = "set-parameter",
        .title = "Set parameter",
        .explanation = "Moves u, where the construction is shown.",
        .synonyms = "u t",
        .group = CommandGroup::construct,
        .fields = {field::parameter<&SetParameter::u>("u", "where in the domain").beginning_with<current_parameter>()},
        .refusal = no_curve,
        .run = body_of<set_parameter>};
    return spec;
}

const CommandSpec& StepParameterBack::spec() {
    static const CommandSpec spec{.name = "step-parameter-back",
                                  .title = "Step back",
                                  .explanation = "Moves u back by a hundredth of the domain.",
                                  .group = CommandGroup::construct,
                                  .offered = in_the_window,
                                  .shortcut = {Key::comma, {}},
                                  .refusal = no_curve,
                                  .run = body_of<step_parameter<StepParameterBack, -1>>};
    return spec;
}

const CommandSpec& StepParameterForward::spec() {
    static const CommandSpec spec{.name = "step-parameter-forward",
                                  .title = "Step forward",
                                  .explanation = "Moves u forward by a hundredth of the domain.",
                                  .group = CommandGroup::construct,
                                  .offered = in_the_window,
                                  .shortcut = {Key::period, {}},
                                  .refusal = no_curve,
                                  .run = body_of<step_parameter<StepParameterForward, 1>>};
    return spec;
}

const CommandSpec& TogglePlay::spec() {
    static const CommandSpec spec{.name = "toggle-play",
                                  .title = "Play",
                                  .explanation = "Runs u along the domain, or stops it.",
                                  .synonyms = "animate run pause",
                                  .group = CommandGroup::construct,
                                  .offered = in_the_window,
                                  .shortcut = {Key::p, {}},
                                  .refusal = no_curve,
                                  .is_checked = is_playing,
                                  .run = body_of<toggle_play>};
    return spec;
}

const CommandSpec& TogglePingPong::spec() {
    static const CommandSpec spec{.name = "toggle-ping-pong",
                                  .title = "Back and forth",
                                  .explanation = "Lets the running u turn at the ends, or jump back to the start.",
                                  .synonyms = "loop ping-pong",
                                  .group = CommandGroup::construct,
                                  .offered = in_the_window,
                                  .is_checked = is_ping_pong,
                                  .run = body_of<toggle_ping_pong>};
    return spec;
}

const CommandSpec& SetBlossomValues::spec() {
    static const CommandSpec spec{
        .name = "set-blossom-values",
        .title = "Blossoms by value",
        .explanation = "Writes blossoms with the values of the knots, or with their indices.",
        .synonyms = "polar form labels",
        .group = CommandGroup::construct,
        .offered = in_the_window,
        .fields = {field::flag<&SetBlossomValues::by_value>("by-value", "yes for values, no for indices")},
        .run = body_of<set_blossom_values>};
    return spec;
}

const CommandSpec& SetSpeed::spec() {
    static const CommandSpec spec{
        .name = "set-speed",
        .title = "Set speed",
        .explanation = "Sets how fast u runs; at 1 it crosses the domain in five seconds.",
        .synonyms = "animation",
        .group = CommandGroup::construct,
        .offered = in_the_window,
        .fields = {field::number<&SetSpeed::speed>("speed", "fifths of the domain per second, 0.01 to 20")
                       .at_least(least_speed)
                       .at_most(most_speed)
                       .beginning_with<current_speed>()},
        .run = body_of<set_speed>};
    return spec;
}

const CommandSpec& SetLevel::spec() {
    static const CommandSpec spec{
        .name = "set-level",
        .title = "Set level",
        .explanation = "Shows the construction up to a level.",
        .synonyms = "de Boor Casteljau",
        .group = CommandGroup::construct,
        .offered = in_the_window,
        .fields = {field::count<&SetLevel::level>("n", "the last level shown, or none for all")
                       .absent_as("-1")
                       .required()
                       .beginning_with<current_level>()},
        .refusal = no_curve,
        .run = body_of<set_level>};
    return spec;
}

const CommandSpec& PreviousLevel::spec() {
    static const CommandSpec spec{.name = "previous-level",
                                  .title = "Previous level",
                                  .explanation = "Shows one level fewer of the construction.",
                                  .group = CommandGroup::construct,
                                  .offered = in_the_window,
                                  .shortcut = {Key::page_up, {}},
                                  .refusal = no_curve,
                                  .run = body_of<step_level<PreviousLevel, -1>>};
    return spec;
}

const CommandSpec& NextLevel::spec() {
    static const CommandSpec spec{.name = "next-level",
                                  .title = "Next level",
                                  .explanation = "Shows one more level of the construction.",
                                  .group = CommandGroup::construct,
                                  .offered = in_the_window,
                                  .shortcut = {Key::page_down, {}},
                                  .refusal = no_curve,
                                  .run = body_of<step_level<NextLevel, 1>>};
    return spec;
}

void add_construction_commands(CommandTable& table) {
    add_all<SetParameter, StepParameterBack, StepParameterForward, TogglePlay, TogglePingPong, SetSpeed>(table);
    add_all<SetBlossomValues>(table);
    add_all<SetLevel, PreviousLevel, NextLevel>(table);
}

}  // namespace batten::editor
