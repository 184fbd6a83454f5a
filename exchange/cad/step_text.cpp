#include "exchange/cad/step_text.h"

#include <algorithm>
#include <charconv>

#include "core/base/ascii.h"
#include "core/base/number_text.h"

namespace batten::exchange {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

// The first word of a file has two signs that words of instances have not.
bool is_in_word(char c) {
    return begins_step_word(c) || core::is_digit(c) || c == '_' || c == '-';
}

}  // namespace

bool begins_step_word(char c) {
    return core::is_letter(c) || c == '!';
}

void StepText::go_on(std::size_t count) {
    at_ = std::min(text_.size(), at_ + count);
}

void StepText::skip_byte_order_mark() {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (rest().starts_with(mark)) go_on(mark.size());
}

char StepText::next() {
    while (!is_at_end()) {
        if (rest().starts_with("/*"))
            skip_comment();
        else if (is_blank(text_[at_]))
            ++at_;
        else
            return text_[at_];
    }
    return '\0';
}

bool StepText::take(char c) {
    if (next() != c) return false;
    go_on();
    return true;
}

void StepText::skip_comment() {
    const std::size_t end = text_.find("*/", at_ + 2);
    at_ = end == std::string_view::npos ? text_.size() : end + 2;
}

bool StepText::take_quoted(char quote) {
    if (!take(quote)) return false;
    while (!is_at_end()) {
        at_ = std::min(text_.find(quote, at_), text_.size());
        go_on();
        if (is_at_end() || text_[at_] != quote) return text_[at_ - 1] == quote;
        go_on();
    }
    return false;
}

std::string_view StepText::take_word() {
    next();
    const std::size_t begin = at_;
    while (!is_at_end() && is_in_word(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
}

std::optional<StepId> StepText::take_id() {
    if (!take('#')) return std::nullopt;
    StepId id = 0;
    const auto [end, error] = std::from_chars(rest().data(), rest().data() + rest().size(), id);
    if (error != std::errc()) return std::nullopt;
    go_on(static_cast<std::size_t>(end - rest().data()));
    return id;
}

bool StepText::take_number() {
    const auto number = core::leading_number(rest());
    if (number) go_on(number->length);
    return number.has_value();
}

void StepText::skip_statement() {
    while (next() != ';' && !is_at_end())
        if (!take_quoted('\'')) go_on();
    go_on();
}

std::string step_text_for_occt(std::string_view text) {
    StepText signs(text);
    signs.skip_byte_order_mark();
    std::string plain;
    plain.reserve(text.size());
    std::size_t copied = signs.at();
    const auto leave_out = [&](std::size_t begin, std::size_t end) {
        plain.append(text.substr(copied, begin - copied));
        copied = end;
    };
    char last = ' ';
    for (char sign = signs.next(); sign != '\0'; last = sign, sign = signs.next()) {
        const std::size_t begin = signs.at();
        if (signs.take_id()) {
            const std::size_t behind = signs.at();
            if (signs.next() == '=') leave_out(behind, signs.at());
        } else if (signs.at() == begin && !signs.take_quoted('\'') && !signs.take_quoted('"')) {
            signs.go_on();
            if (sign == ';' && last == ';') leave_out(begin, signs.at());
        }
    }
    leave_out(text.size(), text.size());
    return plain;
}

}  // namespace batten::exchange
