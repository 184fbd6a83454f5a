#include "core/document/file_stamp.h"

#include <sys/stat.h>

namespace batten::core {

namespace {

FileStamp stamp_of(const struct stat& found) {
    return {found.st_dev, found.st_ino, found.st_size, found.st_mtim.tv_sec, found.st_mtim.tv_nsec};
}

}  // namespace

std::optional<FileStamp> file_stamp(int descriptor) {
    struct stat found {};
    if (fstat(descriptor, &found) != 0) return std::nullopt;
    return stamp_of(found);
}

std::optional<FileStamp> file_stamp(const std::filesystem::path& path) {
    struct stat found {};
    if (stat(path.c_str(), &found) != 0) return std::nullopt;
    return stamp_of(found);
}

}  // namespace batten::core
