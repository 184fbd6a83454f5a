#include "core/document/detail/json_checks.h"

#include <algorithm>
#include <iterator>

#include "core/base/sentence.h"
#include "core/document/detail/object_reader.h"

namespace batten::core {

namespace {

// The library says "[...] parse error at line 1, column 2: syntax error while parsing value - invalid literal; last
// read: '[N'". Kept is what was wrong and expected; what was read last may be long and need not be UTF-8.
std::string without_decoration(std::string message) {
    if (const auto dash = message.find(" - "); dash != std::string::npos) message.erase(0, dash + 3);
    const auto last_read = message.find("; last read: '");
    if (last_read != std::string::npos) {
        const auto expected = message.rfind("; expected ");
        const bool is_followed = expected != std::string::npos && expected > last_read;
        message.erase(last_read, is_followed ? expected - last_read : std::string::npos);
    }
    return message;
}

// The stream as the library reads it: a range that ends where the stream does, or where no more may be read.
class StreamIterator {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = char;

    // Without a stream it is the end of every range.
    StreamIterator() = default;

    // `allowance` is of how many bytes may be read.
    StreamIterator(TextStream& text, std::size_t& allowance) : text_(&text), allowance_(&allowance) {}

    char operator*() const { return text_->front(); }
    StreamIterator& operator++() {
        text_->skip(1);
        --*allowance_;
        return *this;
    }
    bool operator==(const StreamIterator& other) const { return is_at_end() == other.is_at_end(); }

  private:
    bool is_at_end() const { return text_ == nullptr || *allowance_ == 0 || text_->is_at_end(); }

    TextStream* text_ = nullptr;
    std::size_t* allowance_ = nullptr;
};

}  // namespace

FileResult<void> JsonChecks::read(std::size_t most_bytes) {
    std::size_t allowance = most_bytes;
    const bool is_read = Json::sax_parse(StreamIterator(text_, allowance), StreamIterator(), this);
    if (text_.is_at_end() && text_.error()) return tl::unexpected(*text_.error());
    if (allowance == 0)
        return tl::unexpected(
            FileError{text_.line_and_column(text_.position()),
                      sentence("beside the numbers of curves there are more than {most} MiB, the most that is read",
                               {{"most", most_bytes >> 20U}})});
    if (!is_read) return tl::unexpected(error_);
    return {};
}

bool JsonChecks::enter() {
    names_.emplace_back();
    return names_.size() <= deepest_nesting ||
           refuse_here(sentence("lists and objects are nested more than {most} deep, the most that is read",
                                {{"most", deepest_nesting}}));
}

bool JsonChecks::add_name(const std::string& name) {
    std::set<std::string>& names = names_.back();
    if (names.size() == most_members)
        return refuse_here(
            sentence("an object has more than {most} members, the most that is read", {{"most", most_members}}));
    return names.insert(name).second ||
           refuse_here(sentence("the member \"{name}\" occurs twice in one object; every name may occur once",
                                {{"name", short_name(name)}}));
}

bool JsonChecks::parse_error(std::size_t byte, const std::string& /*token*/,
                             const nlohmann::detail::exception& exception) {
    // Counted from 1, and without what was taken; at the front of an empty text there is no byte.
    const std::string where = text_.line_and_column(bytes_taken_ + std::max<std::size_t>(byte, 1) - 1);
    // The only error of another kind than syntax is a number beyond the range of doubles.
    const bool is_syntax = dynamic_cast<const Json::parse_error*>(&exception) != nullptr;
    if (!is_syntax) return refuse({where, "the number is too large; numbers must be finite"});
    return refuse({where, sentence("this is not JSON: {reason}", {{"reason", without_decoration(exception.what())}})});
}

bool JsonChecks::refuse_here(std::string what) {
    return refuse({text_.line_and_column(std::max<std::size_t>(text_.position(), 1) - 1), std::move(what)});
}

bool JsonChecks::refuse(FileError error) {
    error_ = std::move(error);
    return false;
}

}  // namespace batten::core
