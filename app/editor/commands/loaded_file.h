/// Reads files that are opened or added, whoever wrote them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/fields/field.h"
#include "app/editor/words/length.h"
#include "core/document/native_file.h"
#include "exchange/format.h"

namespace batten::editor {

struct LoadedFile {
    core::Document document;
    bool is_foreign = false;             ///< of another program
    std::vector<std::string> remarks{};  ///< what is to be said of its curves, as whole sentences
    bool has_more = false;               ///< than what could be read
};

/// How long it takes is told, and what is read so far; both may be empty.
struct LoadingTold {
    core::Progress progress{};
    core::PointsRead points_read{};
};

/// The document in the file at `path`, read as `format`: none means by its ending, which for most is that of Batten's
/// own files. Only ordinary files are read: a pipe would keep the window waiting. The refusal names file and place.
Outcome<LoadedFile> load_file(const std::filesystem::path& path, std::optional<exchange::Format> format,
                              const LoadingTold& told = {});

/// Why the file at `path` cannot be read or written: "wave.json: line 3, column 7: ..."; an error of the whole file
/// names its path, of which the file's name is enough.
Refusal file_refusal(const std::filesystem::path& path, const core::FileError& error);

/// What a report says: how far off the copies are, and what was left out.
std::vector<std::string> report_words(const Units& units, const exchange::Report& report);

}  // namespace batten::editor
