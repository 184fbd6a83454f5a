/// Reads and writes Batten's own JSON files.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/document/document.h"
#include "core/document/file_text.h"

namespace batten::core {

/// Files of more bytes are refused, so that input without end has one, and never written. The numbers of curves alone
/// can be so many: documents of 10,000,000 points, rational and of 17 digits each, are smaller.
inline constexpr std::size_t most_document_bytes = std::size_t{1} << 30U;

/// Is told the control points of all curves of a file while they are read, the next few at a time, in its order.
/// Nothing about them is checked yet, and those that are written in an unusual way are left out.
using PointsRead = std::function<void(std::span<const Point> points)>;

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
/// `progress` is told how many of them are written, and at last that all are.
std::string format_document(const Document& document, const Progress& progress = {});

/// parse_document of the file's content, which is never held whole: besides the document itself the numbers of its
/// curves take at most twice their memory. `progress` is told how much is read, where the size of the file is known;
/// `points_read` then is told the points up to there. Errors also: those of read_text, with
/// most_document_bytes for its limit.
[[nodiscard]] FileResult<Document> load_document(const std::filesystem::path& path, const Progress& progress = {},
                                                 const PointsRead& points_read = {});

/// The same for what the open file `descriptor` still has; `name` stands for it in errors.
[[nodiscard]] FileResult<Document> load_document(int descriptor, const std::string& name);

/// Saves format_document by replace_text, so that the old file stays whole on any error, and where `progress` stops it.
/// Errors also: a text of more than most_document_bytes, which could not be read again. The stamp is of what was
/// written.
[[nodiscard]] FileResult<FileStamp> save_document(const Document& document, const std::filesystem::path& path,
                                                  const Progress& progress = {});

}  // namespace batten::core
