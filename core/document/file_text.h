/// Whole files as text: read within a limit, and replaced at once.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "core/document/file_stamp.h"

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

/// Texts of more bytes, which are held whole, are refused, so that input without end has one. Documents, which are not
/// held whole, may be larger (native_file.h).
inline constexpr std::size_t most_file_bytes = std::size_t{128} << 20U;

/// The content of the file at `path`. A zero byte, which no text has, is the last one read. Errors: a folder; what
/// cannot be opened or read to its end; more than most_file_bytes. Waits for pipes.
[[nodiscard]] FileResult<std::string> read_text(const std::filesystem::path& path);

/// The same for what the open file `descriptor` still has; `name` stands for it in errors.
[[nodiscard]] FileResult<std::string> read_text(int descriptor, const std::string& name);

/// The content of a file that is no text, zero bytes and all. Errors likewise.
[[nodiscard]] FileResult<std::string> read_bytes(const std::filesystem::path& path);

/// Writes `text` to a temporary file beside `path`, flushes it to disk, renames it and flushes the folder, so that the
/// file has the old content or the new one. A link is followed, also to a file that is not there yet. A file of several
/// names (hard links) keeps them all: once the temporary file is on disk, the text is written into the file itself;
/// where that comes to an end on the way, the temporary file stays, and the error names it. Signals to the thread wait
/// for the end; going beyond the limit of file sizes is an error like others. Other errors leave the old file as it was
/// and no temporary one. Keeps the permissions of the old file, its owner and group where the user may, and its
/// attributes and access lists where the file system does.
[[nodiscard]] FileResult<void> replace_text(const std::filesystem::path& path, std::string_view text);

/// The same; the stamp is of what was written, whatever is at `path` by now.
[[nodiscard]] FileResult<FileStamp> replace_and_stamp(const std::filesystem::path& path, std::string_view text);

/// Has the names of new files in `folder` on disk, so that they are there after a crash; does nothing where the file
/// system cannot.
void flush_folder(const std::filesystem::path& folder);

}  // namespace batten::core
