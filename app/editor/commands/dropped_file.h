/// What is done with a file that is dropped on the window or named at the start.
#pragma once

#include <filesystem>

#include "app/editor/command.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// Adds a picture by the name of an image, opens the form for a table; opens any other file, or adds it to the document
/// where it is not the first of several.
Command command_for_file(const EditorState& state, const std::filesystem::path& path, bool is_first);

}  // namespace batten::editor
