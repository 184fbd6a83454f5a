#include "core/document/native_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/base/sentence.h"

namespace batten::core {

namespace {

namespace fs = std::filesystem;

tl::unexpected<FileError> refuse(const fs::path& path, const std::string& what) {
    return tl::unexpected(FileError{path.string(), what});
}

// `pattern` has the place {reason}, for what the system says.
tl::unexpected<FileError> refuse_by_system(const fs::path& path, const char* pattern) {
    return refuse(path, sentence(pattern, {{"reason", std::strerror(errno)}}));
}

// A new file beside the one to be replaced; removed again unless it took its place.
class TemporaryFile {
  public:
    explicit TemporaryFile(const fs::path& target) {
        constexpr int most_attempts = 100;
        constexpr mode_t open_for_all = 0666;  // the user's mask takes away what it should
        for (int attempt = 0; attempt < most_attempts && file_ < 0; ++attempt) {
            path_ = target;
            path_ += fmt::format(".{}-{}.tmp", getpid(), attempt);
            file_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, open_for_all);
            if (file_ < 0 && errno != EEXIST) return;
        }
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (file_ < 0) return;
        close(file_);
        if (!has_replaced_) unlink(path_.c_str());
    }

    bool is_open() const { return file_ >= 0; }

    bool write_all(std::string_view text) {
        while (!text.empty()) {
            const ssize_t written = write(file_, text.data(), text.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) return false;
            text.remove_prefix(static_cast<std::size_t>(written));
        }
        return true;
    }

    bool flush_to_disk() { return fsync(file_) == 0; }
    bool set_permissions(mode_t mode) { return fchmod(file_, mode) == 0; }

    bool replace(const fs::path& target) {
        has_replaced_ = rename(path_.c_str(), target.c_str()) == 0;
        return has_replaced_;
    }

  private:
    fs::path path_;
    int file_ = -1;
    bool has_replaced_ = false;
};

// The file itself where `path` is a link to it, so that saving does not replace the link.
fs::path resolved(const fs::path& path) {
    std::error_code error;
    const fs::path target = fs::canonical(path, error);
    return error ? path : target;
}

}  // namespace

std::string FileError::sentence() const {
    return where.empty() ? what : core::sentence("{where}: {what}", {{"where", where}, {"what", what}});
}

FileResult<Curve> load_curve(const fs::path& path) {
    const FileResult<Document> document = load_document(path);
    if (!document) return tl::unexpected(document.error());
    const DocumentCurve* active = document->active_curve();
    if (active == nullptr) return refuse(path, "the file has no curve; one is needed");
    return *active->curve;
}

FileResult<void> save_curve(const Curve& curve, const fs::path& path, const std::string& name) {
    Document document;
    DocumentCurve& entry = document.curves.emplace_back();
    entry.name = name;
    entry.curve = std::make_shared<const Curve>(curve);
    return save_document(document, path);
}

FileResult<Document> load_document(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) return refuse(path, "this is a folder; a file is needed");
    std::ifstream file(path, std::ios::binary);
    if (!file) return refuse_by_system(path, "the file cannot be opened: {reason}");
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad()) return refuse_by_system(path, "the file cannot be read: {reason}");
    return parse_document(text);
}

FileResult<void> save_document(const Document& document, const fs::path& path) {
    const fs::path target = resolved(path);
    const auto fail = [&](const char* pattern) { return refuse_by_system(path, pattern); };
    struct stat old {};
    const bool exists = stat(target.c_str(), &old) == 0;
    if (exists && !S_ISREG(old.st_mode)) return refuse(path, "this is not an ordinary file, so it cannot be saved to");
    if (exists && access(target.c_str(), W_OK) != 0) return fail("the file cannot be written: {reason}");
    TemporaryFile temporary(target);
    if (!temporary.is_open()) return fail("no file can be made in this folder: {reason}");
    constexpr mode_t permission_bits = 07777;
    if (exists && !temporary.set_permissions(old.st_mode & permission_bits))
        return fail("its permissions cannot be kept: {reason}");
    if (!temporary.write_all(format_document(document)) || !temporary.flush_to_disk())
        return fail("the file cannot be written: {reason}");
    if (!temporary.replace(target)) return fail("the file cannot be replaced: {reason}");
    return {};
}

}  // namespace batten::core
