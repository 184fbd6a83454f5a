#include "app/editor/commands/tool_commands.h"

#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/state.h"

namespace batten::editor {

namespace {

template <Tool tool>
Outcome<void> take(EditorState& state, const TakeTool<tool>&) {
    take_tool(state, tool);
    return {};
}

template <Tool tool>
bool is_taken(const EditorState& state) {
    return state.tool == tool;
}

template <Tool tool>
CommandSpec taking(const char* name, const char* title, const char* explanation, Key key) {
    return {.name = name,
            .title = title,
            .explanation = explanation,
            .synonyms = "tool",
            .group = CommandGroup::edit,
            .submenu = "Tools",
            .offered = {.scripts = false, .key_sheet = false},
            .shortcut = {key, {}},
            .is_checked = is_taken<tool>,
            .run = body_of<take<tool>>};
}

Outcome<void> set_tool(EditorState& state, const SetTool& command) {
    take_tool(state, command.tool);
    return {};
}

Tool current_tool(const EditorState& state) {
    return state.tool;
}

}  // namespace

template <>
const CommandSpec& TakeTool<Tool::select>::spec() {
    static const CommandSpec spec =
        taking<Tool::select>("tool-select", "Select and move", "Selects and drags control points and knots.", Key::v);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::add_point>::spec() {
    static const CommandSpec spec = taking<Tool::add_point>(
        "tool-add-point", "Add points", "Adds a control point where you click on the polygon.", Key::a);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::insert_knot>::spec() {
    static const CommandSpec spec =
        taking<Tool::insert_knot>("tool-insert-knot", "Insert knots",
                                  "Inserts a knot where you click on the curve, which stays as it is.", Key::k);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::weight>::spec() {
    static const CommandSpec spec = taking<Tool::weight>("tool-weight", "Change weights",
                                                         "Changes the weight of the control point you drag.", Key::w);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::draw_curve>::spec() {
    static const CommandSpec spec = taking<Tool::draw_curve>(
        "tool-draw-curve", "Draw curve", "Draws a new curve, one click for each control point.", Key::n);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::parameter>::spec() {
    static const CommandSpec spec =
        taking<Tool::parameter>("tool-parameter", "Move parameter", "Drags the parameter u along the curve.", Key::u);
    return spec;
}

const CommandSpec& SetTool::spec() {
    static const CommandSpec spec{
        .name = "set-tool",
        .title = "Set tool",
        .explanation = "Takes a tool by its name.",
        .group = CommandGroup::edit,
        .offered = {.menu = false, .scripts = false},
        .fields = {field::choice<&SetTool::tool>("tool", "which tool").beginning_with<current_tool>()},
        .run = body_of<set_tool>};
    return spec;
}

const CommandSpec& take_tool_spec(Tool tool) {
    switch (tool) {
        case Tool::select:
            return TakeTool<Tool::select>::spec();
        case Tool::add_point:
            return TakeTool<Tool::add_point>::spec();
        case Tool::insert_knot:
            return TakeTool<Tool::insert_knot>::spec();
        case Tool::weight:
            return TakeTool<Tool::weight>::spec();
        case Tool::draw_curve:
            return TakeTool<Tool::draw_curve>::spec();
        case Tool::parameter:
            break;
    }
    return TakeTool<Tool::parameter>::spec();
}

void add_tool_commands(CommandTable& table) {
    for (const Tool tool : all_tools) table.emplace_back(take_tool_spec(tool));
    add_all<SetTool>(table);
}

}  // namespace batten::editor
