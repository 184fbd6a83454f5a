#include "app/editor/command_table.h"

#include <algorithm>

#include "app/editor/commands/groups.h"

namespace batten::editor {

namespace {

std::vector<CommandSpec> make_table() {
    std::vector<CommandSpec> table;
    add_file_commands(table);
    add_edit_commands(table);
    add_selection_commands(table);
    add_tool_commands(table);
    add_point_commands(table);
    add_curve_commands(table);
    add_knot_commands(table);
    add_refinement_commands(table);
    add_piece_commands(table);
    add_closing_commands(table);
    add_document_commands(table);
    add_making_commands(table);
    add_analysis_commands(table);
    add_measuring_commands(table);
    add_form_commands(table);
    add_fitting_commands(table);
    add_shape_commands(table);
    add_construction_commands(table);
    add_view_commands(table);
    add_help_commands(table);
    add_gesture_commands(table);
    // Menus are in the order of the groups; within a group the order above stands.
    std::stable_sort(table.begin(), table.end(),
                     [](const CommandSpec& a, const CommandSpec& b) { return a.group < b.group; });
    return table;
}

}  // namespace

std::span<const CommandSpec> command_table() {
    static const std::vector<CommandSpec> table = make_table();
    return table;
}

const CommandSpec* find_command(const std::string& name) {
    for (const CommandSpec& spec : command_table())
        if (name == spec.name) return &spec;
    return nullptr;
}

const CommandSpec* find_command(const Shortcut& shortcut) {
    if (shortcut.key == Key::none) return nullptr;
    for (const CommandSpec& spec : command_table())
        if (spec.shortcut == shortcut || spec.second_shortcut == shortcut) return &spec;
    return nullptr;
}

}  // namespace batten::editor
