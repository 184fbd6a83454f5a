/// The names of Batten's own files.
#pragma once

#include <filesystem>

#include "app/editor/fields/field.h"

namespace batten::editor {

/// Why curves are not written to a file called that: its name ends like a file of another kind, "wave.svg". An ending
/// is a dot and at most five letters or digits, not digits alone, or at most ten small letters: "wave 1.5" and a
/// temporary "out.Yk3xQz" have none. An ending without a name, ".svg" or ".json", would be a hidden file.
std::optional<Refusal> foreign_ending(const std::filesystem::path& path);

/// The path of a file to save: with the ending of native files where it has none. A foreign one is refused.
Outcome<std::filesystem::path> native_path(const std::filesystem::path& path);

}  // namespace batten::editor
