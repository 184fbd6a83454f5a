/// A text that is read once, from its front to its end, without being held whole.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/document/detail/input_file.h"

namespace batten::core {

/// The bytes of a text one after the other. The text ends early at a zero byte, which no text has, and where reading
/// fails; error() says so.
class TextStream {
  public:
    /// `text` must outlive the stream.
    explicit TextStream(std::string_view text);

    /// Reads `file`, which must outlive the stream, block by block, and tells `progress` after each.
    TextStream(InputFile& file, Progress progress);

    bool is_at_end() { return next_ == end_ && !read_on(); }

    /// The next byte; there must be one.
    char front() const { return *next_; }
    void skip(std::size_t count) { next_ += count; }

    /// The next bytes: `count` of them at least, unless the text ends before.
    std::string_view ahead(std::size_t count) {
        while (static_cast<std::size_t>(end_ - next_) < count && read_on()) continue;
        return {next_, static_cast<std::size_t>(end_ - next_)};
    }

    /// How many bytes are read.
    std::size_t position() const { return forgotten_ + static_cast<std::size_t>(next_ - begin_); }

    /// "line 3, column 7" for the byte at `position`, counted from 0: one of the last few before the next one,
    /// or one that is not read yet.
    std::string line_and_column(std::size_t position) const;

    /// Why the text ended early, if it has come to that.
    const std::optional<FileError>& error() const { return error_; }

  private:
    bool read_on();
    void forget_what_is_read();
    // Of `at_hand`, which begins at begin_, in the whole text.
    std::size_t start_of_last_line(std::string_view at_hand) const;
    void end_at_zero_byte(const char* from);

    InputFile* file_ = nullptr;
    Progress progress_{};
    std::vector<char> block_{};
    const char* begin_ = nullptr;  // what is at hand, with a few bytes before the next one
    const char* next_ = nullptr;
    const char* end_ = nullptr;
    std::size_t forgotten_ = 0;        // bytes before begin_
    std::size_t lines_forgotten_ = 0;  // ends of lines among them
    std::size_t line_start_ = 0;       // where the line of begin_ starts, in the whole text
    bool has_ended_ = false;
    std::optional<FileError> error_{};
};

}  // namespace batten::core
