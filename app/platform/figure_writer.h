/// Writes what the window shows as a figure.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/editor/state/state.h"

namespace batten::platform {

/// Writes the figure to `path` in the format of its ending, and returns a sentence for each kind of things that it
/// lacks. The error is a sentence: no such format, a size that no picture has, or a file that cannot be written.
tl::expected<std::vector<std::string>, std::string> write_figure(const editor::EditorState& state,
                                                                 const std::filesystem::path& path,
                                                                 const editor::FigureForm& form);

}  // namespace batten::platform
