/// The groups from which the command table is put together; one function for each source of this folder.
#pragma once

#include <functional>
#include <vector>

#include "app/editor/command.h"
#include "app/editor/command_spec.h"

namespace batten::editor {

/// The table while it is put together.
using CommandTable = std::vector<std::reference_wrapper<const CommandSpec>>;

/// Adds the descriptions of commands, in order.
template <DescribedCommand... Commands>
void add_all(CommandTable& table) {
    (table.emplace_back(Commands::spec()), ...);
}

void add_file_commands(CommandTable& table);
void add_figure_commands(CommandTable& table);
void add_edit_commands(CommandTable& table);
void add_code_commands(CommandTable& table);
void add_selection_commands(CommandTable& table);
void add_selected_curve_commands(CommandTable& table);
void add_group_commands(CommandTable& table);
void add_tool_commands(CommandTable& table);
void add_pen_commands(CommandTable& table);
void add_point_commands(CommandTable& table);
void add_pin_commands(CommandTable& table);
void add_weight_commands(CommandTable& table);
void add_degree_commands(CommandTable& table);
void add_knot_commands(CommandTable& table);
void add_tear_commands(CommandTable& table);
void add_refinement_commands(CommandTable& table);
void add_subdivision_commands(CommandTable& table);
void add_piece_commands(CommandTable& table);
void add_joint_commands(CommandTable& table);
void add_joint_tool_commands(CommandTable& table);
void add_joint_mark_commands(CommandTable& table);
void add_corner_commands(CommandTable& table);
void add_trim_commands(CommandTable& table);
void add_closing_commands(CommandTable& table);
void add_document_commands(CommandTable& table);
void add_making_commands(CommandTable& table);
void add_analysis_commands(CommandTable& table);
void add_measuring_commands(CommandTable& table);
void add_form_commands(CommandTable& table);
void add_drawing_commands(CommandTable& table);
void add_fit_point_commands(CommandTable& table);
void add_fitting_commands(CommandTable& table);
void add_combine_commands(CommandTable& table);
void add_stroke_commands(CommandTable& table);
void add_shape_commands(CommandTable& table);
void add_fairing_commands(CommandTable& table);
void add_brush_commands(CommandTable& table);
void add_transform_commands(CommandTable& table);
void add_arranging_commands(CommandTable& table);
void add_symmetry_commands(CommandTable& table);
void add_construction_commands(CommandTable& table);
void add_invariance_commands(CommandTable& table);
void add_knot_question_commands(CommandTable& table);
void add_snap_commands(CommandTable& table);
void add_axis_commands(CommandTable& table);
void add_unit_commands(CommandTable& table);
void add_view_commands(CommandTable& table);
void add_shape_view_commands(CommandTable& table);
void add_overlay_commands(CommandTable& table);
void add_recovery_commands(CommandTable& table);
void add_lesson_commands(CommandTable& table);
void add_table_commands(CommandTable& table);
void add_picture_commands(CommandTable& table);
void add_trace_commands(CommandTable& table);
void add_help_commands(CommandTable& table);

}  // namespace batten::editor
