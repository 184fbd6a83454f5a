#include "core/document/detail/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/base/sentence.h"

namespace batten::core {

namespace {

namespace fs = std::filesystem;

std::size_t bytes_ahead(int descriptor) {
    struct stat status {};
    if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return 0;
    const off_t ahead = status.st_size - std::max<off_t>(0, lseek(descriptor, 0, SEEK_CUR));
    return ahead > 0 ? static_cast<std::size_t>(ahead) : 0;
}

}  // namespace

tl::unexpected<FileError> refuse_by_system(const std::string& name, const char* pattern) {
    return tl::unexpected(FileError{name, sentence(pattern, {{"reason", std::strerror(errno)}})});
}

FileResult<InputFile> InputFile::open(const fs::path& path, std::size_t most_bytes) {
    std::error_code error;
    if (fs::is_directory(path, error))
        return tl::unexpected(FileError{path.string(), "this is a folder; a file is needed"});
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (descriptor < 0) return refuse_by_system(path.string(), "the file cannot be opened: {reason}");
    InputFile file(descriptor, path.string(), most_bytes);
    file.is_own_ = true;
    return file;
}

InputFile::InputFile(int descriptor, std::string name, std::size_t most_bytes)
    : descriptor_(descriptor),
      name_(std::move(name)),
      most_bytes_(most_bytes),
      expected_bytes_(bytes_ahead(descriptor)) {}

InputFile::InputFile(InputFile&& other) noexcept
    : descriptor_(other.descriptor_),
      is_own_(std::exchange(other.is_own_, false)),
      name_(std::move(other.name_)),
      most_bytes_(other.most_bytes_),
      expected_bytes_(other.expected_bytes_),
      bytes_read_(other.bytes_read_) {}

InputFile::~InputFile() {
    if (is_own_) close(descriptor_);
}

FileResult<std::size_t> InputFile::read(char* target, std::size_t room) {
    ssize_t count = -1;
    do {
        count = ::read(descriptor_, target, room);
    } while (count < 0 && errno == EINTR);
    if (count < 0) return refuse_by_system(name_, "the file cannot be read: {reason}");
    bytes_read_ += static_cast<std::size_t>(count);
    if (bytes_read_ <= most_bytes_) return static_cast<std::size_t>(count);
    return tl::unexpected(FileError{
        name_, sentence("there are more than {most} MiB, the most that is read", {{"most", most_bytes_ >> 20U}})});
}

}  // namespace batten::core
