/// A file, or standard input, that is read from its front to its end.
#pragma once

#include "core/document/file_text.h"

namespace batten::core {

/// The error of a call of the system, just now, about the file `name`; `pattern` has the place {reason}.
tl::unexpected<FileError> refuse_by_system(const std::string& name, const char* pattern);

class InputFile {
  public:
    /// Opens the file at `path`, of which `most_bytes` are read. Errors: a folder; what cannot be opened. Waits for
    /// pipes.
    [[nodiscard]] static FileResult<InputFile> open(const std::filesystem::path& path,
                                                    std::size_t most_bytes = most_file_bytes);

    /// What the open `descriptor` still has, which stays open; `name` stands for it in errors.
    InputFile(int descriptor, std::string name, std::size_t most_bytes = most_file_bytes);

    ~InputFile();
    InputFile(InputFile&& other) noexcept;
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    InputFile& operator=(InputFile&&) = delete;

    /// How many bytes there seem to be, from where reading begins; 0 where that is not known.
    std::size_t expected_bytes() const { return expected_bytes_; }

    std::size_t bytes_read() const { return bytes_read_; }

    /// Reads at least one byte and at most `room` to `target`; returns how many, 0 at the end. Errors: the system's;
    /// more bytes than are allowed.
    [[nodiscard]] FileResult<std::size_t> read(char* target, std::size_t room);

  private:
    int descriptor_;
    bool is_own_ = false;
    std::string name_;
    std::size_t most_bytes_;
    std::size_t expected_bytes_ = 0;
    std::size_t bytes_read_ = 0;
};

}  // namespace batten::core
