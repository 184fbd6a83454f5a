#include "core/document/detail/json_text.h"

#include <algorithm>
#include <set>

#include "core/base/sentence.h"

namespace batten::core {

namespace {

std::string line_and_column(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t line_start = before.rfind('\n') + 1;
    return sentence("line {line}, column {column}", {{"line", line}, {"column", before.size() - line_start + 1}});
}

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

// Reads through the text without building anything and notes the first defect.
class SyntaxCheck : public nlohmann::json_sax<Json> {
  public:
    explicit SyntaxCheck(std::string_view text) : text_(text) {}

    const FileError& error() const { return error_; }

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_array() override { return leave(); }

    bool key(string_t& name) override {
        if (names_.back().size() == most_members)
            return refuse({"", sentence("an object has more than {most} members; this is not a curve document",
                                        {{"most", most_members}})});
        if (names_.back().insert(name).second) return true;
        return refuse({"", sentence("the member \"{name}\" occurs twice in one object; every name may occur once",
                                    {{"name", name}})});
    }

    bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception& exception) override {
        // The only error of another kind than syntax is a number beyond the range of doubles.
        const bool is_syntax = dynamic_cast<const Json::parse_error*>(&exception) != nullptr;
        if (!is_syntax)
            return refuse({line_and_column(text_, byte), "the number is too large; numbers must be finite"});
        return refuse({line_and_column(text_, byte),
                       sentence("this is not JSON: {reason}", {{"reason", without_decoration(exception.what())}})});
    }

  private:
    bool enter() {
        names_.emplace_back();
        if (names_.size() <= deepest_nesting) return true;
        return refuse({"", sentence("lists and objects are nested more than {most} deep; this is not a curve document",
                                    {{"most", deepest_nesting}})});
    }

    bool leave() {
        names_.pop_back();
        return true;
    }

    bool refuse(FileError found) {
        error_ = std::move(found);
        return false;
    }

    std::string_view text_;
    std::vector<std::set<std::string>> names_;
    FileError error_;
};

}  // namespace

FileResult<Json> parse_json(std::string_view text) {
    // The library takes a zero byte for the end of the text and would not see what is behind it.
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
        return tl::unexpected(
            FileError{line_and_column(text, zero + 1), "this is not JSON: there is a zero byte, which no text has"});
    SyntaxCheck check(text);
    if (!Json::sax_parse(text, &check)) return tl::unexpected(check.error());
    return Json::parse(text, nullptr, false);
}

}  // namespace batten::core
