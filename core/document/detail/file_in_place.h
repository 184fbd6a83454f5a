/// A file that is written anew without another taking its place.
#pragma once

#include <filesystem>
#include <string_view>

namespace batten::core {

/// What fails leaves its reason in errno.
class FileInPlace {
  public:
    /// The file at `path`, as it is.
    explicit FileInPlace(const std::filesystem::path& path);
    FileInPlace(const FileInPlace&) = delete;
    FileInPlace& operator=(const FileInPlace&) = delete;
    ~FileInPlace();

    bool is_open() const { return file_ >= 0; }
    int descriptor() const { return file_; }

    /// Takes the room of so many bytes on disk where the file system can; where that fails the file is as it was.
    bool make_room(std::size_t bytes);

    /// Has `text` alone in the file, on disk. Where that fails it may have part of both.
    bool write_whole(std::string_view text);

  private:
    int file_;
};

}  // namespace batten::core
