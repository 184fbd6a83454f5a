/// The names of Batten's own files.
#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/fields/field.h"
#include "exchange/format.h"

namespace batten::editor {

/// Why curves are not written to a file called that: its name ends like a file of another kind, "wave.svg". An ending
/// is a dot and at most five letters or digits, not digits alone, or at most ten small letters: "wave 1.5" and a
/// temporary "out.Yk3xQz" have none. An ending without a name, ".svg" or ".json", would be a hidden file.
std::optional<Refusal> foreign_ending(const std::filesystem::path& path);

/// The same for a name that may have the ending of a format of exchange, all of which the refusal names.
std::optional<Refusal> foreign_result(const std::filesystem::path& path);

/// The path of a file to save: with the ending of native files where it has none. A foreign one is refused.
Outcome<std::filesystem::path> native_path(const std::filesystem::path& path);

/// Whether the name is that of a figure that shows curves and does not hold them: "wave.pdf".
bool is_named_as_figure(const std::filesystem::path& path);

/// A file to save, and as what.
struct SavedName {
    std::filesystem::path path;
    std::optional<exchange::Format> format{};  ///< none: Batten's own, or a figure
    bool is_figure = false;
};

/// The file that is meant by `path` and `format`, by the ending where none is chosen. A name without an ending, or with
/// that of another format, is given that of the format; one with a foreign ending needs a format and keeps it.
Outcome<SavedName> saved_name(const std::filesystem::path& path, std::optional<exchange::Format> format);

}  // namespace batten::editor
