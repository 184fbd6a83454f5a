/// Curves in files of other programs.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/progress.h"
#include "exchange/format.h"

namespace batten::exchange {

/// The curves of the file at `path`. Errors: those of core::read_text and of the format's reader; the format is not
/// read.
[[nodiscard]] core::FileResult<Imported> load_curves(const std::filesystem::path& path, Format format);

/// The same for what the open file `descriptor` still has; `name` stands for it in errors.
[[nodiscard]] core::FileResult<Imported> load_curves(int descriptor, const std::string& name, Format format);

/// The text of a file with the visible curves of `document`. Errors: those of the format's writer; the format is not
/// written.
[[nodiscard]] core::FileResult<Exported> write_curves(const core::Document& document, Format format,
                                                      const WriteOptions& options = {});

/// Writes them by core::replace_text. `progress` is told that all is done before the file changes, so that what it
/// stops has changed nothing. Errors also: those of replace_text.
[[nodiscard]] core::FileResult<Report> save_curves(const core::Document& document, const std::filesystem::path& path,
                                                   Format format, const WriteOptions& options = {},
                                                   const core::Progress& progress = {});

}  // namespace batten::exchange
