#include "core/document/file_text.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include "core/base/sentence.h"
#include "core/document/detail/file_in_place.h"
#include "core/document/detail/input_file.h"
#include "core/document/detail/signals_held.h"
#include "core/document/detail/temporary_file.h"

namespace batten::core {

namespace {

namespace fs = std::filesystem;

tl::unexpected<FileError> refused(const std::string& name, const std::string& what) {
    return tl::unexpected(FileError{name, what});
}

// Reads to the end, and where `stops_at_zero` to a zero byte.
FileResult<std::string> whole_content(InputFile& file, bool stops_at_zero) {
    std::string text;
    text.reserve(std::min(file.expected_bytes(), most_file_bytes));
    constexpr std::size_t block_bytes = 65536;
    std::vector<char> block(block_bytes);
    for (;;) {
        const FileResult<std::size_t> count = file.read(block.data(), block.size());
        if (!count) return tl::unexpected(count.error());
        if (*count == 0) return text;
        const std::string_view more(block.data(), *count);
        const std::size_t zero = stops_at_zero ? more.find('\0') : std::string_view::npos;
        text.append(more.substr(0, zero == std::string_view::npos ? zero : zero + 1));
        if (zero != std::string_view::npos) return text;
    }
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

// Whether `path`, or a link on the way from it, is the name that the system gives to what a program has opened, as
// /dev/stdout and /dev/fd/3 are: there the file may be in use, and has another name.
bool names_open_file(fs::path path) {
    constexpr int most_links = 40;
    std::error_code error;
    for (int i = 0; i < most_links && fs::is_symlink(path, error); ++i) {
        const fs::path folder = fs::canonical(path.has_parent_path() ? path.parent_path() : ".", error);
        if (folder.string().starts_with("/proc/")) return true;
        path = path.parent_path() / fs::read_symlink(path, error);
    }
    return false;
}

}  // namespace

std::string FileError::sentence() const {
    return where.empty() ? what : core::sentence("{where}: {what}", {{"where", where}, {"what", what}});
}

FileResult<std::string> read_text(int descriptor, const std::string& name) {
    InputFile file(descriptor, name);
    return whole_content(file, true);
}

FileResult<std::string> read_text(const fs::path& path) {
    return InputFile::open(path).and_then([](InputFile file) { return whole_content(file, true); });
}

FileResult<std::string> read_bytes(const fs::path& path) {
    return InputFile::open(path).and_then([](InputFile file) { return whole_content(file, false); });
}

void flush_folder(const fs::path& folder) {
    const int opened = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (opened < 0) return;
    fsync(opened);
    close(opened);
}

namespace {

// Writes `text` into the file at `target`, which keeps its names. `beside`, with the same text, stays only where that
// came to an end on the way.
FileResult<FileStamp> written_in_place(const std::string& name, const fs::path& target, std::string_view text,
                                       TemporaryFile& beside) {
    FileInPlace file(target);
    if (!file.is_open() || !beside.close_beside() || !file.make_room(text.size()))
        return refuse_by_system(name, "the file cannot be written: {reason}");
    if (!file.write_whole(text)) {
        const std::string reason = std::strerror(errno);
        beside.keep();
        return refused(name, sentence("the file cannot be written whole: {reason}; what was to be in it is in {file}",
                                      {{"reason", reason}, {"file", beside.path().string()}}));
    }
    return file_stamp(file.descriptor()).value_or(FileStamp{});
}

}  // namespace

FileResult<FileStamp> replace_and_stamp(const fs::path& path, std::string_view text) {
    const fs::path target = resolved(path);
    const auto fail = [&](const char* pattern) { return refuse_by_system(path.string(), pattern); };
    struct stat old {};
    const bool exists = stat(path.c_str(), &old) == 0;
    if (!exists && errno == ELOOP) return fail("the file cannot be written: {reason}");
    if (exists && !S_ISREG(old.st_mode))
        return refused(path.string(), "this is not an ordinary file, so it cannot be saved to");
    if (exists && access(target.c_str(), W_OK) != 0) return fail("the file cannot be written: {reason}");
    if (names_open_file(path))
        return refused(path.string(),
                       "this is what a program has opened, not a file in a folder, so it cannot be saved to");
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    if (std::error_code error; !fs::exists(folder, error) && !error)
        return refused(path.string(), sentence("there is no folder {folder}", {{"folder", folder.string()}}));
    const SignalsHeld held;
    TemporaryFile temporary(target);
    if (!temporary.is_open()) return fail("no file can be made in this folder: {reason}");
    if (exists && !temporary.take_rights(target, old)) return fail("its permissions cannot be kept: {reason}");
    if (!temporary.write_all(text) || !temporary.flush_to_disk()) return fail("the file cannot be written: {reason}");
    if (exists && old.st_nlink > 1) return written_in_place(path.string(), target, text, temporary);
    const FileStamp stamp = temporary.stamp().value_or(FileStamp{});
    if (!temporary.replace(target)) return fail("the file cannot be replaced: {reason}");
    return stamp;
}

FileResult<void> replace_text(const fs::path& path, std::string_view text) {
    return replace_and_stamp(path, text).map([](const FileStamp&) {});
}

}  // namespace batten::core
