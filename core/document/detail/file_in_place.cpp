#include "core/document/detail/file_in_place.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace batten::core {

FileInPlace::FileInPlace(const std::filesystem::path& path) : file_(open(path.c_str(), O_WRONLY | O_CLOEXEC)) {}

FileInPlace::~FileInPlace() {
    if (file_ >= 0) close(file_);
}

bool FileInPlace::make_room(std::size_t bytes) {
    struct stat status {};
    if (fstat(file_, &status) != 0) return false;
    const off_t more = static_cast<off_t>(bytes) - status.st_size;
    if (more <= 0) return true;
    const int error = posix_fallocate(file_, status.st_size, more);
    if (error == 0 || error == EOPNOTSUPP || error == EINVAL) return true;
    static_cast<void>(ftruncate(file_, status.st_size));
    errno = error;
    return false;
}

bool FileInPlace::write_whole(std::string_view text) {
    const auto size = static_cast<off_t>(text.size());
    while (!text.empty()) {
        const ssize_t written = pwrite(file_, text.data(), text.size(), size - static_cast<off_t>(text.size()));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return ftruncate(file_, size) == 0 && fsync(file_) == 0;
}

}  // namespace batten::core
