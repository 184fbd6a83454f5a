/// The images in the files of pictures, read when they are first looked at.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "render/image.h"

namespace batten::editor {

/// What a file holds: an image, or what is wrong with it, one sentence.
struct LoadedPicture {
    std::shared_ptr<const render::Image> image;  ///< null where there is a problem
    std::string problem;
};

class LoadedPictures {
  public:
    /// What the file at the absolute `path` holds; it is read again when it was written since, and looked for again
    /// where it was missing. Cost: a question to the file system, but for reading.
    const LoadedPicture& of(const std::filesystem::path& path) const;

  private:
    struct Entry {
        std::filesystem::file_time_type written{};
        bool is_read = false;
        LoadedPicture loaded;
    };
    mutable std::map<std::filesystem::path, Entry> entries_;
};

}  // namespace batten::editor
