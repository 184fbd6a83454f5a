/// A new file beside one that it is to replace.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string_view>

#include "core/document/file_stamp.h"

namespace batten::core {

/// Removed again at the end of its life unless it took the place of another. What fails leaves its reason in errno.
class TemporaryFile {
  public:
    /// A file of a name that is not in use, beside `target`.
    explicit TemporaryFile(const std::filesystem::path& target);
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile();

    bool is_open() const { return file_ >= 0; }
    const std::filesystem::path& path() const { return path_; }
    std::optional<FileStamp> stamp() const { return file_stamp(file_); }
    bool write_all(std::string_view text);
    bool flush_to_disk();
    /// Owner and group of the file `old`, which has `status`, as far as the user may give them away; the permissions of
    /// a group that is another are those of all others. Otherwise its access list and the attributes that users gave
    /// it, too, where the file system keeps them.
    bool take_rights(const std::filesystem::path& old, const struct stat& status);
    /// Closes the file, which has its name on disk then.
    bool close_beside();
    /// The file stays at the end.
    void keep() { is_kept_ = true; }
    /// Closes the file and gives it the name of `target`. Once that is done, the folder is flushed to disk as well
    /// where its file system can do so.
    bool replace(const std::filesystem::path& target);

  private:
    std::filesystem::path path_;
    int file_ = -1;
    bool is_made_ = false;
    bool is_kept_ = false;
};

}  // namespace batten::core
