/// Tells whether a file is still the one that was read or written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace batten::core {

/// What changes whenever a program writes a file or puts another in its place; but for one that writes as many bytes
/// into the same file and sets its time back.
struct FileStamp {
    std::uint64_t device = 0;
    std::uint64_t file = 0;    ///< the number that the file system gave it
    std::int64_t size = 0;     ///< bytes
    std::int64_t seconds = 0;  ///< when it was written last, since 1970
    std::int64_t nanoseconds = 0;
    bool operator==(const FileStamp&) const = default;
};

/// The stamp of an open file; none where `descriptor` is none.
std::optional<FileStamp> file_stamp(int descriptor);

/// The stamp of what is at `path` now, links followed; none where nothing can be found there.
std::optional<FileStamp> file_stamp(const std::filesystem::path& path);

}  // namespace batten::core
