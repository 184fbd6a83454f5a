#include "app/editor/command_table.h"

#include <algorithm>

#include "app/editor/commands/groups.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

// What edits the points, knots and pieces of curves that are there.
void add_editing_commands(CommandTable& table) {
    add_file_commands(table);
    add_recovery_commands(table);
    add_figure_commands(table);
    add_edit_commands(table);
    add_code_commands(table);
    add_picture_commands(table);
    add_table_commands(table);
    add_selection_commands(table);
    add_tool_commands(table);
    add_pen_commands(table);
    add_point_commands(table);
    add_pin_commands(table);
    add_weight_commands(table);
    add_degree_commands(table);
    add_knot_commands(table);
    add_tear_commands(table);
    add_refinement_commands(table);
    add_subdivision_commands(table);
    add_piece_commands(table);
    add_joint_commands(table);
    add_joint_tool_commands(table);
    add_joint_mark_commands(table);
    add_corner_commands(table);
    add_trim_commands(table);
    add_closing_commands(table);
    add_document_commands(table);
    add_selected_curve_commands(table);
    add_group_commands(table);
}

// What makes, measures and shapes curves, and what is seen of them.
void add_other_commands(CommandTable& table) {
    add_making_commands(table);
    add_trace_commands(table);
    add_analysis_commands(table);
    add_measuring_commands(table);
    add_form_commands(table);
    add_drawing_commands(table);
    add_fit_point_commands(table);
    add_fitting_commands(table);
    add_combine_commands(table);
    add_stroke_commands(table);
    add_shape_commands(table);
    add_fairing_commands(table);
    add_brush_commands(table);
    add_transform_commands(table);
    add_arranging_commands(table);
    add_symmetry_commands(table);
    add_construction_commands(table);
    add_invariance_commands(table);
    add_knot_question_commands(table);
    add_view_commands(table);
    add_snap_commands(table);
    add_axis_commands(table);
    add_unit_commands(table);
    add_lesson_commands(table);
    add_shape_view_commands(table);
    add_help_commands(table);
}

CommandTable make_table() {
    CommandTable table;
    add_editing_commands(table);
    add_other_commands(table);
    // Menus are in the order of the groups; within a group the order above stands.
    std::stable_sort(table.begin(), table.end(),
                     [](const CommandSpec& a, const CommandSpec& b) { return a.group < b.group; });
    return table;
}

}  // namespace

std::span<const std::reference_wrapper<const CommandSpec>> command_table() {
    static const CommandTable table = make_table();
    return table;
}

const CommandSpec* find_command(std::string_view name) {
    for (const CommandSpec& spec : command_table())
        if (name == spec.name) return &spec;
    return nullptr;
}

Outcome<const CommandSpec*> command_named(std::string_view name) {
    if (const CommandSpec* spec = find_command(name)) return spec;
    return tl::unexpected(core::sentence("there is no command called '{name}'", {{"name", name}}));
}

const CommandSpec* find_command(const Shortcut& shortcut) {
    if (shortcut.key == Key::none) return nullptr;
    for (const CommandSpec& spec : command_table())
        if (spec.shortcut == shortcut || spec.second_shortcut == shortcut) return &spec;
    return nullptr;
}

}  // namespace batten::editor
