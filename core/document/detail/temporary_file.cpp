#include "core/document/detail/temporary_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "core/document/file_text.h"

namespace batten::core {

TemporaryFile::TemporaryFile(const std::filesystem::path& target) {
    constexpr int most_attempts = 100;
    constexpr mode_t open_for_all = 0666;  // the user's mask takes away what it should
    for (int attempt = 0; attempt < most_attempts && file_ < 0; ++attempt) {
        path_ = target.parent_path() / fmt::format(".batten-{}-{}.tmp", getpid(), attempt);
        file_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, open_for_all);
        if (file_ < 0 && errno != EEXIST) return;
    }
    is_made_ = file_ >= 0;
}

TemporaryFile::~TemporaryFile() {
    if (file_ >= 0) close(file_);
    if (is_made_ && !has_replaced_) unlink(path_.c_str());
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

bool TemporaryFile::set_rights(unsigned owner, unsigned group, unsigned mode) {
    constexpr unsigned of_group = 0070;
    constexpr unsigned of_others = 0007;
    constexpr unsigned group_shift = 3;
    struct stat own {};
    if (fstat(file_, &own) != 0) return false;
    const bool keeps_owner = own.st_uid == owner && own.st_gid == group;
    const bool has_group = keeps_owner || fchown(file_, owner, group) == 0 || own.st_gid == group ||
                           fchown(file_, static_cast<uid_t>(-1), group) == 0;
    const unsigned given = has_group ? mode : (mode & ~of_group) | ((mode & of_others) << group_shift);
    return fchmod(file_, given) == 0;
}

bool TemporaryFile::replace(const std::filesystem::path& target) {
    if (close(std::exchange(file_, -1)) != 0) return false;
    has_replaced_ = rename(path_.c_str(), target.c_str()) == 0;
    if (has_replaced_) flush_folder(target.parent_path());
    return has_replaced_;
}

}  // namespace batten::core
