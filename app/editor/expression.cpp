#include "app/editor/expression.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "core/base/sentence.h"

namespace batten::editor {
namespace {

using Value = tl::expected<double, std::string>;

constexpr std::string_view blanks = " \t\n\r";
constexpr std::string_view minus_sign = "\u2212";
constexpr int deepest = 100;  // parentheses and signs recurse: a pasted "((((..." must not exhaust the stack

/// A parser by recursive descent: sum = product {+ product}, product = signed {* signed}, signed = [-] signed | (sum) |
/// number.
class Parser {
  public:
    explicit Parser(std::string_view text) : text_(text) {}

    Value parse() {
        skip_blanks();
        if (rest().empty()) return fail("type a number, such as 0.5, 1/3 or 2*(3+1)");
        Value value = sum();
        if (!value) return value;
        if (!rest().empty()) return unexpected();
        if (!std::isfinite(*value)) return fail("the result is too large for a number");
        return value;
    }

  private:
    std::string_view rest() const { return text_.substr(position_); }

    static Value fail(std::string sentence) { return tl::make_unexpected(std::move(sentence)); }

    Value unexpected() const {
        if (rest().front() == ')') return fail("a closing parenthesis has no opening one");
        if (rest().front() == ',') return fail("a comma cannot be read here; write decimals with a point, as in 0.5");
        return fail(core::sentence("“{found}” cannot be read; numbers, + - * / and parentheses are allowed",
                                   {{"found", character()}}));
    }

    /// The whole UTF-8 character at the position.
    std::string_view character() const {
        std::size_t length = 1;
        while (length < rest().size() && (static_cast<unsigned char>(rest()[length]) & 0xC0U) == 0x80U) ++length;
        return rest().substr(0, length);
    }

    void skip_blanks() { position_ = std::min(text_.find_first_not_of(blanks, position_), text_.size()); }

    bool accept(std::string_view token) {
        if (!rest().starts_with(token)) return false;
        position_ += token.size();
        skip_blanks();
        return true;
    }

    bool accept_minus() { return accept("-") || accept(minus_sign); }

    Value sum() {
        Value value = product();
        while (value) {
            const bool adds = accept("+");
            if (!adds && !accept_minus()) break;
            Value next = product();
            if (!next) return next;
            value = adds ? *value + *next : *value - *next;
        }
        return value;
    }

    Value product() {
        Value value = signed_operand();
        while (value) {
            const bool multiplies = accept("*");
            if (!multiplies && !accept("/")) break;
            Value next = signed_operand();
            if (!next) return next;
            if (!multiplies && *next == 0.0) return fail("a division by zero has no value");
            value = multiplies ? *value * *next : *value / *next;
        }
        return value;
    }

    Value signed_operand() {
        if (depth_ >= deepest) return fail("too many parentheses or signs inside one another");
        ++depth_;
        Value value = accept_minus() ? negated() : accept("+") ? signed_operand() : operand();
        --depth_;
        return value;
    }

    Value negated() {
        Value value = signed_operand();
        if (value) value = -*value;
        return value;
    }

    Value operand() {
        if (!accept("(")) return number();
        Value value = sum();
        if (value && !accept(")")) return rest().empty() ? fail("a closing parenthesis is missing") : unexpected();
        return value;
    }

    Value number() {
        if (rest().empty()) return fail("a number is missing at the end");
        if (rest().front() == ')') return fail("a number is missing before the closing parenthesis");
        if (rest().find_first_of("0123456789.") != 0) return unexpected();
        double value = 0.0;
        const auto [end, error] = std::from_chars(rest().data(), rest().data() + rest().size(), value);
        const auto length = static_cast<std::size_t>(end - rest().data());
        if (error == std::errc::result_out_of_range)
            return fail(
                core::sentence("“{number}” is outside the range of numbers", {{"number", rest().substr(0, length)}}));
        if (error != std::errc{}) return unexpected();
        position_ += length;
        skip_blanks();
        return value;
    }

    std::string_view text_;
    std::size_t position_ = 0;
    int depth_ = 0;
};

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view without_brackets(std::string_view text) {
    const bool has_brackets = text.size() >= 2 && ((text.front() == '[' && text.back() == ']') ||
                                                   (text.front() == '{' && text.back() == '}'));
    return has_brackets ? trimmed(text.substr(1, text.size() - 2)) : text;
}

/// The entries of a list; between separators an entry may be empty, while a run of blanks separates once.
std::vector<std::string_view> entries_of(std::string_view text) {
    const bool has_separators = text.find_first_of(",;") != std::string_view::npos;
    const std::string_view separators = has_separators ? ",;" : blanks;
    std::vector<std::string_view> entries;
    while (true) {
        const std::size_t end = text.find_first_of(separators);
        entries.push_back(trimmed(text.substr(0, end)));
        if (end == std::string_view::npos) return entries;
        text.remove_prefix(end + 1);
        if (!has_separators) text = trimmed(text);
    }
}

}  // namespace

tl::expected<double, std::string> parse_expression(std::string_view text) {
    return Parser(text).parse();
}

tl::expected<std::vector<double>, std::string> parse_expressions(std::string_view text) {
    const std::string_view list = without_brackets(trimmed(text));
    std::vector<double> values;
    if (list.empty()) return values;
    for (const std::string_view entry : entries_of(list)) {
        const Value value = parse_expression(entry);
        if (!value)
            return tl::make_unexpected(
                core::sentence("entry {index}: {problem}", {{"index", values.size()}, {"problem", value.error()}}));
        values.push_back(*value);
    }
    return values;
}

}  // namespace batten::editor
