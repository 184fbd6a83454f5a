/// The groups from which the command table is put together; one function for each source of this folder.
#pragma once

#include <vector>

#include "app/editor/command_table.h"

namespace batten::editor {

void add_file_commands(std::vector<CommandSpec>& table);
void add_edit_commands(std::vector<CommandSpec>& table);
void add_selection_commands(std::vector<CommandSpec>& table);
void add_tool_commands(std::vector<CommandSpec>& table);
void add_point_commands(std::vector<CommandSpec>& table);
void add_curve_commands(std::vector<CommandSpec>& table);
void add_knot_commands(std::vector<CommandSpec>& table);
void add_refinement_commands(std::vector<CommandSpec>& table);
void add_piece_commands(std::vector<CommandSpec>& table);
void add_closing_commands(std::vector<CommandSpec>& table);
void add_making_commands(std::vector<CommandSpec>& table);
void add_form_commands(std::vector<CommandSpec>& table);
void add_fitting_commands(std::vector<CommandSpec>& table);
void add_shape_commands(std::vector<CommandSpec>& table);
void add_document_commands(std::vector<CommandSpec>& table);
void add_analysis_commands(std::vector<CommandSpec>& table);
void add_measuring_commands(std::vector<CommandSpec>& table);
void add_construction_commands(std::vector<CommandSpec>& table);
void add_view_commands(std::vector<CommandSpec>& table);
void add_help_commands(std::vector<CommandSpec>& table);
void add_gesture_commands(std::vector<CommandSpec>& table);

}  // namespace batten::editor
