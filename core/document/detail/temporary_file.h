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
    bool set_permissions(unsigned mode);
    bool replace(const std::filesystem::path& target);

  private:
    std::filesystem::path path_;
    int file_ = -1;
    bool has_replaced_ = false;
};

}  // namespace batten::core
