/// Reads the files that the subcommands are given.
#pragma once

#include <optional>

#include "app/cli/subcommands.h"
#include "core/document/document.h"
#include "core/document/native_file.h"
#include "exchange/format.h"

namespace batten::cli {

/// Writes "file: where: what" to the errors. `where` may be empty.
void say_error(Output output, const std::filesystem::path& file, const std::string& where, const std::string& what);

/// The same for why `file` could not be read or written.
void say_error(Output output, const std::filesystem::path& file, const core::FileError& error);

/// The curves in `file`, or on standard input, read as that kind: none means by the ending, which for most is that of
/// Batten's own files.
core::FileResult<exchange::Imported> read_curves(const std::filesystem::path& file,
                                                 std::optional<FileKind> kind = std::nullopt);

/// The format of another program that is meant by `kind`, or by the ending of `file` where there is none; none for
/// Batten's own.
std::optional<exchange::Format> format_meant(const std::filesystem::path& file, std::optional<FileKind> kind);

/// The document in `file`, or on standard input; what of it was left out goes to the errors.
core::FileResult<core::Document> read_document(Output output, const std::filesystem::path& file);

/// The same; none after saying why not.
std::optional<core::Document> load(Output output, const std::filesystem::path& file);

/// The index of the curve that `name` names or numbers, or of the active one where it is empty; none after saying why
/// not.
std::optional<std::size_t> find_curve(Output output, const std::filesystem::path& file, const core::Document& document,
                                      const std::string& name);

}  // namespace batten::cli
