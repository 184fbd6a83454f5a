/// A new file beside one that it is to replace.
#pragma once

#include <filesystem>
#include <string_view>

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
    bool write_all(std::string_view text);
    bool flush_to_disk();
    /// Owner and group as far as the user may give them away; the permissions of a group that is another are those of
    /// all others.
    bool set_rights(unsigned owner, unsigned group, unsigned mode);
    /// Closes the file and gives it the name of `target`. Once that is done, the folder is flushed to disk as well
    /// where its file system can do so.
    bool replace(const std::filesystem::path& target);

  private:
    std::filesystem::path path_;
    int file_ = -1;
    bool is_made_ = false;
    bool has_replaced_ = false;
};

}  // namespace batten::core
