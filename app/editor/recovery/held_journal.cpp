#include "app/editor/recovery/held_journal.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/document/file_text.h"

namespace batten::editor {

namespace {

namespace fs = std::filesystem;

tl::unexpected<Refusal> refused_by_disk() {
    return tl::unexpected(Refusal(std::strerror(errno)));
}

bool has_written(int file, std::string_view bytes, std::int64_t place) {
    while (!bytes.empty()) {
        const ssize_t count = pwrite(file, bytes.data(), bytes.size(), place);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(count));
        place += count;
    }
    return fdatasync(file) == 0;
}

bool is_locked(int file) {
    return flock(file, LOCK_EX | LOCK_NB) == 0;
}

// A file that is gone at the end unless it is kept.
class NewFile {
  public:
    explicit NewFile(fs::path path) : path_(std::move(path)) {
        constexpr mode_t for_the_user_alone = 0600;
        file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, for_the_user_alone);
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile() {
        if (file_ < 0) return;
        unlink(path_.c_str());
        close(file_);
    }

    int file() const { return file_; }
    bool has_become(const fs::path& path) const { return rename(path_.c_str(), path.c_str()) == 0; }
    int keep() { return std::exchange(file_, -1); }

  private:
    fs::path path_;
    int file_ = -1;
};

}  // namespace

HeldJournal::HeldJournal(fs::path path) : path_(std::move(path)) {}

HeldJournal::~HeldJournal() {
    if (file_ >= 0) close(file_);
}

std::shared_ptr<HeldJournal> HeldJournal::take(const fs::path& path) {
    auto journal = std::make_shared<HeldJournal>(path);
    journal->file_ = open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
    struct stat status {};
    // Another session may have removed it before the lock was ours.
    const bool is_ours = journal->file_ >= 0 && is_locked(journal->file_) && journal->is_there() &&
                         fstat(journal->file_, &status) == 0 && S_ISREG(status.st_mode);
    journal->size_ = status.st_size;
    return is_ours ? journal : nullptr;
}

bool HeldJournal::is_there() const {
    struct stat status {};
    return file_ >= 0 && fstat(file_, &status) == 0 && status.st_nlink > 0;
}

bool HeldJournal::is_whole() const {
    struct stat status {};
    return is_there() && fstat(file_, &status) == 0 && status.st_size >= size_;
}

Outcome<std::string> HeldJournal::part(std::int64_t place, std::size_t count_asked) const {
    const auto left = static_cast<std::size_t>(std::max<std::int64_t>(size_ - place, 0));
    std::string content(std::min(count_asked, left), '\0');
    std::size_t done = 0;
    while (done < content.size()) {
        const ssize_t count =
            pread(file_, content.data() + done, content.size() - done, place + static_cast<std::int64_t>(done));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return refused_by_disk();
        if (count == 0) break;
        done += static_cast<std::size_t>(count);
    }
    content.resize(done);
    return content;
}

Outcome<void> HeldJournal::replace(std::string_view content) {
    std::error_code error;
    fs::create_directories(path_.parent_path(), error);
    if (error) return tl::unexpected(Refusal(error.message()));
    NewFile next(fmt::format("{}.new", path_.string()));
    if (next.file() < 0 || !is_locked(next.file()) || !has_written(next.file(), content, 0) || !next.has_become(path_))
        return refused_by_disk();
    core::flush_folder(path_.parent_path());
    if (file_ >= 0) close(file_);
    file_ = next.keep();
    size_ = static_cast<std::int64_t>(content.size());
    return {};
}

Outcome<void> HeldJournal::append(std::string_view record) {
    if (!has_written(file_, record, size_)) {
        const auto refusal = refused_by_disk();
        // What cannot be cut off is no whole record either, and the next one is written over it.
        static_cast<void>(ftruncate(file_, size_));
        return refusal;
    }
    size_ += static_cast<std::int64_t>(record.size());
    return {};
}

void HeldJournal::remove() {
    if (is_there()) unlink(path_.c_str());
}

}  // namespace batten::editor
