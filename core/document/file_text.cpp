#include "core/document/file_text.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "core/base/sentence.h"
#include "core/document/detail/signals_held.h"
#include "core/document/detail/temporary_file.h"

namespace batten::core {

namespace {

namespace fs = std::filesystem;

tl::unexpected<FileError> refused(const std::string& name, const std::string& what) {
    return tl::unexpected(FileError{name, what});
}

// `pattern` has the place {reason}, for what the system says.
tl::unexpected<FileError> refused_by_system(const std::string& name, const char* pattern) {
    return refused(name, sentence(pattern, {{"reason", std::strerror(errno)}}));
}

// Appends what one call reads; returns how many bytes that were, 0 at the end, -1 on errors.
ssize_t read_more(int descriptor, std::string& text) {
    constexpr std::size_t block_bytes = 65536;
    std::array<char, block_bytes> block;
    ssize_t count = -1;
    do {
        count = read(descriptor, block.data(), block.size());
    } while (count < 0 && errno == EINTR);
    if (count > 0) text.append(block.data(), static_cast<std::size_t>(count));
    return count;
}

// The file itself where `path` is a link, or a chain of links, so that saving does not replace the link. A link to
// nothing leads to what it names; links in a circle stay as they are.
fs::path resolved(fs::path path) {
    constexpr int most_links = 40;
    std::error_code error;
    for (int i = 0; i < most_links && fs::is_symlink(path, error); ++i) {
        const fs::path target = fs::read_symlink(path, error);
        if (error) break;
        path = path.parent_path() / target;
    }
    return path;
}

}  // namespace

std::string FileError::sentence() const {
    return where.empty() ? what : core::sentence("{where}: {what}", {{"where", where}, {"what", what}});
}

FileResult<std::string> read_text(int descriptor, const std::string& name) {
    std::string text;
    for (;;) {
        const std::size_t before = text.size();
        const ssize_t count = read_more(descriptor, text);
        if (count < 0) return refused_by_system(name, "the file cannot be read: {reason}");
        if (count == 0) return text;
        const std::size_t zero = text.find('\0', before);
        if (zero != std::string::npos) return text.substr(0, zero + 1);
        if (text.size() > most_file_bytes)
            return refused(name, sentence("there are more than {most} MiB, the most that is read",
                                          {{"most", most_file_bytes >> 20U}}));
    }
}

FileResult<std::string> read_text(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) return refused(path.string(), "this is a folder; a file is needed");
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (file < 0) return refused_by_system(path.string(), "the file cannot be opened: {reason}");
    FileResult<std::string> text = read_text(file, path.string());
    close(file);
    return text;
}

FileResult<void> replace_text(const fs::path& path, std::string_view text) {
    const fs::path target = resolved(path);
    const auto fail = [&](const char* pattern) { return refused_by_system(path.string(), pattern); };
    struct stat old {};
    const bool exists = stat(target.c_str(), &old) == 0;
    if (!exists && errno == ELOOP) return fail("the file cannot be written: {reason}");
    if (exists && !S_ISREG(old.st_mode))
        return refused(path.string(), "this is not an ordinary file, so it cannot be saved to");
    if (exists && access(target.c_str(), W_OK) != 0) return fail("the file cannot be written: {reason}");
    const SignalsHeld held;
    TemporaryFile temporary(target);
    if (!temporary.is_open()) return fail("no file can be made in this folder: {reason}");
    constexpr mode_t permission_bits = 07777;
    if (exists && !temporary.set_permissions(old.st_mode & permission_bits))
        return fail("its permissions cannot be kept: {reason}");
    if (!temporary.write_all(text) || !temporary.flush_to_disk()) return fail("the file cannot be written: {reason}");
    if (!temporary.replace(target)) return fail("the file cannot be replaced: {reason}");
    return {};
}

}  // namespace batten::core
