#include "core/document/detail/temporary_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace batten::core {

TemporaryFile::TemporaryFile(const std::filesystem::path& target) {
    constexpr int most_attempts = 100;
    constexpr mode_t open_for_all = 0666;  // the user's mask takes away what it should
    for (int attempt = 0; attempt < most_attempts && file_ < 0; ++attempt) {
        path_ = target.parent_path() / fmt::format(".batten-{}-{}.tmp", getpid(), attempt);
        file_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, open_for_all);
        if (file_ < 0 && errno != EEXIST) return;
    }
}

TemporaryFile::~TemporaryFile() {
    if (file_ < 0) return;
    close(file_);
    if (!has_replaced_) unlink(path_.c_str());
}

bool TemporaryFile::write_all(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = write(file_, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

bool TemporaryFile::flush_to_disk() {
    return fsync(file_) == 0;
}

bool TemporaryFile::set_permissions(unsigned mode) {
    return fchmod(file_, mode) == 0;
}

bool TemporaryFile::replace(const std::filesystem::path& target) {
    has_replaced_ = rename(path_.c_str(), target.c_str()) == 0;
    return has_replaced_;
}

}  // namespace batten::core
