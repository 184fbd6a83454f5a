#include "app/editor/commands/groups.h"

namespace batten::editor {

namespace {

template <Tool tool>
Outcome<void> take(EditorState& state, const Arguments&) {
    state.tool = tool;
    return {};
}

template <Tool tool>
bool is_taken(const EditorState& state) {
    return state.tool == tool;
}

template <Tool tool>
void add_tool(std::vector<CommandSpec>& table, const char* name, const char* title, const char* explanation, Key key) {
    table.push_back({.name = name,
                     .title = title,
                     .explanation = explanation,
                     .group = CommandGroup::edit,
                     .shortcut = {key, {}},
                     .is_checked = is_taken<tool>,
                     .act = take<tool>});
}

Outcome<void> set_tool(EditorState& state, const Arguments& arguments) {
    const std::optional<Tool> tool = core::value_named<Tool>(arguments.text(0));
    if (!tool)
        return tl::unexpected("there is no tool called '" + arguments.text(0) +
                              "'; there are select, add-point, insert-knot, weight, draw-curve and parameter");
    state.tool = *tool;
    return {};
}

}  // namespace

void add_tool_commands(std::vector<CommandSpec>& table) {
    add_tool<Tool::select>(table, "tool-select", "Select and move", "Selects and drags control points and knots.",
                           Key::v);
    add_tool<Tool::add_point>(table, "tool-add-point", "Add points",
                              "Adds a control point where you click on the polygon.", Key::a);
    add_tool<Tool::insert_knot>(table, "tool-insert-knot", "Insert knots",
                                "Inserts a knot where you click on the curve, which stays as it is.", Key::k);
    add_tool<Tool::weight>(table, "tool-weight", "Change weights", "Changes the weight of the control point you drag.",
                           Key::w);
    add_tool<Tool::draw_curve>(table, "tool-draw-curve", "Draw curve",
                               "Draws a new curve, one click for each control point.", Key::n);
    add_tool<Tool::parameter>(table, "tool-parameter", "Move parameter", "Drags the parameter u along the curve.",
                              Key::u);
    table.push_back({.name = "set-tool",
                     .title = "Set tool",
                     .explanation = "Takes the tool with this name.",
                     .group = CommandGroup::edit,
                     .parameters = {{"tool", ParameterKind::text,
                                     "select, add-point, insert-knot, weight, draw-curve or parameter"}},
                     .act = set_tool});
}

}  // namespace batten::editor
