/// What commands that measure the active curve share.
#pragma once

#include "app/editor/command_table.h"

namespace batten::editor {

/// The name of the committed active curve; there must be one.
const std::string& active_name(const EditorState& state);

/// "1 cusp", "3 cusps", "no cusps".
std::string count_text(std::size_t count, const char* one, const char* many);

/// Two numbers for a point or vector: "tangent x", "tangent y".
void add_numbers(Finding& finding, const std::string& name, glm::dvec2 vector);

/// Shows `rows` under `title` with the sentence "NAME WHAT" ("wave" + "has 3 cusps").
Outcome<void> show_rows(EditorState& state, const char* title, const std::string& what, std::vector<Finding> rows);

/// A command of the menu Analyze that shows findings of the active curve.
CommandSpec measuring_command(const char* name, const char* title, const char* explanation, const char* submenu,
                              Outcome<void> (*act)(EditorState&, const Arguments&));

}  // namespace batten::editor
