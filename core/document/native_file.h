/// Reads and writes Batten's own JSON files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/document/document.h"

namespace batten::core {

/// Why a text or file was refused.
struct FileError {
    std::string where;  ///< "line 3, column 7", "/curves/0/knots/4", the path of an unreadable file, or empty
    std::string what;   ///< what was found, and what is allowed

    /// "<where>: <what>"
    std::string sentence() const;
};

template <class T>
using FileResult = tl::expected<T, FileError>;

/// The curve in the file at `path`: the active one where it holds several. Errors: those of load_document; the file has
/// no curve.
[[nodiscard]] FileResult<Curve> load_curve(const std::filesystem::path& path);

/// Saves a document that has `curve` alone, under `name`; as save_document.
[[nodiscard]] FileResult<void> save_curve(const Curve& curve, const std::filesystem::path& path,
                                          const std::string& name = "curve");

/// The document in `text`, checked completely. Unknown members are kept, unknown versions refused by name. Without a
/// "kind" the kind is what the values say.
[[nodiscard]] FileResult<Document> parse_document(std::string_view text);

/// The text that parse_document reads back to an equal document; numbers as the shortest text of the same double.
std::string format_document(const Document& document);

/// parse_document of the file's content. Errors also: the file cannot be read.
[[nodiscard]] FileResult<Document> load_document(const std::filesystem::path& path);

/// Writes a temporary file beside `path`, flushes it to disk and renames it; the old file stays whole on any error.
[[nodiscard]] FileResult<void> save_document(const Document& document, const std::filesystem::path& path);

}  // namespace batten::core
