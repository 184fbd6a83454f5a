#include "app/editor/commands/pen_commands.h"

#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/state.h"

namespace batten::editor {

namespace {

// A curve half drawn goes on in the other mode.
void use_pen_mode(EditorState& state, PenMode mode) {
    state.view.pen_mode = mode;
    if (state.tool != Tool::draw_curve) take_tool(state, Tool::draw_curve);
}

template <PenMode mode>
Outcome<void> use_pen(EditorState& state, const UsePen<mode>&) {
    use_pen_mode(state, mode);
    return {};
}

template <PenMode mode>
bool is_pen_used(const EditorState& state) {
    return state.view.pen_mode == mode;
}

template <PenMode mode>
CommandSpec using_pen(const char* name, const char* title, const char* explanation) {
    return {.name = name,
            .title = title,
            .explanation = explanation,
            .synonyms = "draw pen tool",
            .group = CommandGroup::edit,
            .submenu = "Pen",
            .offered = in_the_window,
            .is_checked = is_pen_used<mode>,
            .run = body_of<use_pen<mode>>};
}

Outcome<void> set_pen_mode(EditorState& state, const SetPenMode& command) {
    state.view.pen_mode = command.mode;
    return {};
}

PenMode current_pen_mode(const EditorState& state) {
    return state.view.pen_mode;
}

}  // namespace

template <>
const CommandSpec& UsePen<PenMode::control_points>::spec() {
    static const CommandSpec spec = using_pen<PenMode::control_points>(
        "pen-control-points", "Pen: control points", "Draws a curve with a control point at each click.");
    return spec;
}

template <>
const CommandSpec& UsePen<PenMode::through_c2>::spec() {
    static const CommandSpec spec = using_pen<PenMode::through_c2>(
        "pen-through-c2", "Pen: through points, C²", "Draws a cubic with steady curvature through the points clicked.");
    return spec;
}

template <>
const CommandSpec& UsePen<PenMode::through_local>::spec() {
    static const CommandSpec spec = using_pen<PenMode::through_local>(
        "pen-through-local", "Pen: through points, local",
        "Draws a cubic through the points clicked, of which each moves two spans on either side and no more.");
    return spec;
}

template <>
const CommandSpec& UsePen<PenMode::through_fair>::spec() {
    static const CommandSpec spec = using_pen<PenMode::through_fair>(
        "pen-through-fair", "Pen: through points, fair",
        "Draws a curve of degree 5 through the points clicked whose curvature varies least.");
    return spec;
}

template <>
const CommandSpec& UsePen<PenMode::bezier>::spec() {
    static const CommandSpec spec = using_pen<PenMode::bezier>(
        "pen-bezier", "Pen: Bézier",
        "Draws Bézier pieces: a click makes a corner, a drag the handles of a smooth point.");
    return spec;
}

const CommandSpec& SetPenMode::spec() {
    static const CommandSpec spec{
        .name = "set-pen-mode",
        .title = "Set pen mode",
        .explanation = "Says what the pen makes of the points that are clicked.",
        .group = CommandGroup::edit,
        .offered = {.menu = false, .scripts = false},
        .fields = {field::choice<&SetPenMode::mode>("mode", "what they are").beginning_with<current_pen_mode>()},
        .run = body_of<set_pen_mode>};
    return spec;
}

const CommandSpec& use_pen_spec(PenMode mode) {
    switch (mode) {
        case PenMode::control_points:
            return UsePen<PenMode::control_points>::spec();
        case PenMode::through_c2:
            return UsePen<PenMode::through_c2>::spec();
        case PenMode::through_local:
            return UsePen<PenMode::through_local>::spec();
        case PenMode::through_fair:
            return UsePen<PenMode::through_fair>::spec();
        case PenMode::bezier:
            break;
    }
    return UsePen<PenMode::bezier>::spec();
}

void add_pen_commands(CommandTable& table) {
    for (const auto& entry : core::Names<PenMode>::table) table.emplace_back(use_pen_spec(entry.value));
    add_all<SetPenMode>(table);
}

}  // namespace batten::editor
