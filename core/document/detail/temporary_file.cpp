#include "core/document/detail/temporary_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <linux/limits.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <utility>
#include <vector>

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
    if (is_made_ && !is_kept_) unlink(path_.c_str());
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

namespace {

constexpr const char* access_list = "system.posix_acl_access";

bool is_kept_attribute(std::string_view name) {
    return name.starts_with("user.") || name == access_list;
}

// What cannot be kept is left out.
void copy_attributes(const std::filesystem::path& from, int to) {
    std::vector<char> names(XATTR_LIST_MAX);
    std::vector<char> value(XATTR_SIZE_MAX);
    const ssize_t size = listxattr(from.c_str(), names.data(), names.size());
    for (std::string_view left(names.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))); !left.empty();) {
        const std::string_view name = left.substr(0, left.find('\0'));
        left.remove_prefix(name.size() + 1);
        if (!is_kept_attribute(name)) continue;
        const ssize_t count = getxattr(from.c_str(), name.data(), value.data(), value.size());
        if (count >= 0) static_cast<void>(fsetxattr(to, name.data(), value.data(), static_cast<std::size_t>(count), 0));
    }
}

}  // namespace

bool TemporaryFile::take_rights(const std::filesystem::path& old, const struct stat& status) {
    constexpr unsigned of_group = 0070;
    constexpr unsigned of_others = 0007;
    constexpr unsigned group_shift = 3;
    constexpr unsigned permission_bits = 07777;
    struct stat own {};
    if (fstat(file_, &own) != 0) return false;
    const unsigned mode = status.st_mode & permission_bits;
    const bool keeps_owner = own.st_uid == status.st_uid && own.st_gid == status.st_gid;
    const bool has_group = keeps_owner || fchown(file_, status.st_uid, status.st_gid) == 0 ||
                           own.st_gid == status.st_gid || fchown(file_, static_cast<uid_t>(-1), status.st_gid) == 0;
    static_cast<void>(fremovexattr(file_, access_list));  // that the folder gives to new files
    const unsigned given = has_group ? mode : (mode & ~of_group) | ((mode & of_others) << group_shift);
    if (fchmod(file_, given) != 0) return false;
    if (has_group) copy_attributes(old, file_);
    return true;
}

bool TemporaryFile::close_beside() {
    if (close(std::exchange(file_, -1)) != 0) return false;
    flush_folder(path_.parent_path());
    return true;
}

bool TemporaryFile::replace(const std::filesystem::path& target) {
    if (close(std::exchange(file_, -1)) != 0) return false;
    is_kept_ = rename(path_.c_str(), target.c_str()) == 0;
    if (is_kept_) flush_folder(target.parent_path());
    return is_kept_;
}

}  // namespace batten::core
