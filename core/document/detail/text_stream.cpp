#include "core/document/detail/text_stream.h"

#include <algorithm>
#include <cstring>

#include "core/base/sentence.h"

namespace batten::core {

namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 18U;

// So many bytes before the next one are kept, for the places of errors.
constexpr std::size_t kept_bytes = 16;

std::size_t distance(const char* from, const char* to) {
    return static_cast<std::size_t>(to - from);
}

// Ends of lines. They are few among the bytes, and found faster than counted.
std::size_t count_of_lines(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) ++count;
    return count;
}

}  // namespace

TextStream::TextStream(std::string_view text)
    : begin_(text.data()), next_(text.data()), end_(text.data() + text.size()), has_ended_(true) {
    end_at_zero_byte(begin_);
}

TextStream::TextStream(InputFile& file, Progress progress)
    : file_(&file), progress_(std::move(progress)), block_(block_bytes + kept_bytes) {
    begin_ = next_ = end_ = block_.data();
}

bool TextStream::read_on() {
    if (has_ended_) return false;
    forget_what_is_read();
    if (distance(begin_, end_) == block_.size()) return false;  // all that is at hand is still ahead
    char* const target = block_.data() + distance(begin_, end_);
    const FileResult<std::size_t> count = file_->read(target, block_.size() - distance(begin_, end_));
    if (!count) error_ = count.error();
    has_ended_ = !count || *count == 0;
    if (has_ended_) return false;
    end_ = target + *count;
    end_at_zero_byte(target);
    tell(progress_, std::min(file_->bytes_read(), file_->expected_bytes()), file_->expected_bytes());
    return end_ != target;
}

void TextStream::forget_what_is_read() {
    const char* const kept = next_ - std::min(kept_bytes, distance(begin_, next_));
    const std::string_view forgotten(begin_, distance(begin_, kept));
    lines_forgotten_ += count_of_lines(forgotten);
    line_start_ = start_of_last_line(forgotten);
    forgotten_ += forgotten.size();
    const std::size_t ahead = distance(kept, next_);
    const std::size_t size = distance(kept, end_);
    std::memmove(block_.data(), kept, size);
    begin_ = block_.data();
    next_ = begin_ + ahead;
    end_ = begin_ + size;
}

void TextStream::end_at_zero_byte(const char* from) {
    if (from == end_) return;
    const void* const zero = std::memchr(from, '\0', distance(from, end_));
    if (zero == nullptr) return;
    end_ = static_cast<const char*>(zero);
    has_ended_ = true;
    error_ = FileError{line_and_column(forgotten_ + distance(begin_, end_)),
                       "this is not JSON: there is a zero byte, which no text has"};
}

std::string TextStream::line_and_column(std::size_t position) const {
    const std::string_view before(begin_, std::min(position - forgotten_, distance(begin_, end_)));
    return sentence("line {line}, column {column}",
                    {{"line", lines_forgotten_ + count_of_lines(before) + 1},
                     {"column", forgotten_ + before.size() - start_of_last_line(before) + 1}});
}

std::size_t TextStream::start_of_last_line(std::string_view at_hand) const {
    const std::size_t last_end = at_hand.rfind('\n');
    return last_end == std::string_view::npos ? line_start_ : forgotten_ + last_end + 1;
}

}  // namespace batten::core
