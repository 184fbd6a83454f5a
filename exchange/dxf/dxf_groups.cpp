#include "exchange/dxf/dxf_groups.h"

#include <charconv>

#include "core/base/ascii.h"
#include "core/base/sentence.h"
#include "exchange/places.h"
#include "exchange/utf8_text.h"

namespace batten::exchange {

namespace {

constexpr int comment_code = 999;
constexpr int least_code = -5;
constexpr int most_code = 1071;

std::optional<int> code_of(std::string_view text) {
    int code = 0;
    const char* end = text.data() + text.size();
    const auto [read_end, error] = std::from_chars(text.data(), end, code);
    if (error != std::errc() || read_end != end || code < least_code || code > most_code) return std::nullopt;
    return code;
}

}  // namespace

std::string_view DxfGroups::take_line() {
    ++line_;
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    return core::trimmed(line);
}

std::optional<DxfGroup> DxfGroups::refuse(std::string what) {
    error_ = core::FileError{line_place(line_), std::move(what)};
    rest_ = {};
    return std::nullopt;
}

std::optional<DxfGroup> DxfGroups::next() {
    while (!rest_.empty()) {
        const std::string_view text = take_line();
        const std::optional<int> code = code_of(text);
        constexpr std::size_t longest_quotation = 40;
        if (text.find('\0') != std::string_view::npos) return refuse("there is a zero byte; the file must be text");
        if (!code)
            return refuse(core::sentence("found \"{found}\", but a group code must be a whole number from -5 to 1071",
                                         {{"found", utf8_text(text.substr(0, longest_quotation))}}));
        if (rest_.empty()) return refuse("the file ends after a group code; a value must follow it");
        const std::string_view value = take_line();
        if (value.find('\0') != std::string_view::npos) return refuse("there is a zero byte; the file must be text");
        if (*code != comment_code) return DxfGroup{*code, value, line_};
    }
    return std::nullopt;
}

}  // namespace batten::exchange
