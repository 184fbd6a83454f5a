#include "app/editor/fields/expression.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <system_error>

#include "app/editor/fields/quantity.h"
#include "core/base/ascii.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/base/utf8.h"

namespace batten::editor {
namespace {

using Value = tl::expected<Quantity, std::string>;

constexpr std::string_view minus_sign = "\u2212";
constexpr std::string_view digits_and_marks = "0123456789.,";
constexpr int deepest = 100;  // parentheses, signs and powers recurse: a pasted "((((..." must not exhaust the stack

/// A parser by recursive descent: sum = product {+ product}; product = signed [unit] {* signed [unit]}; signed = [-]
/// signed | power; power = operand [^ signed]; operand = (sum) | name (sum) | pi | number.
class Parser {
  public:
    Parser(std::string_view text, const core::DocumentUnits* lengths) : text_(text), lengths_(lengths) {
        skip_blanks();
    }

    Value parse() {
        if (rest().empty()) return fail("type a number, such as 0.5, 1/3 or sqrt(2)/2");
        const Value value = sum();
        return value && !rest().empty() ? unexpected() : value;
    }

  private:
    std::string_view rest() const { return text_.substr(position_); }

    static Value fail(std::string sentence) { return tl::make_unexpected(std::move(sentence)); }

    Value unexpected() const {
        if (rest().front() == ')') return fail("a closing parenthesis has no opening one");
        if (!name().empty())
            return fail(core::sentence("“{found}” cannot be read here; a product is written with *, as in 2*pi",
                                       {{"found", rest().substr(0, name().size())}}));
        return fail(core::sentence("“{found}” cannot be read here; numbers, + - * / ^ and parentheses are allowed",
                                   {{"found", character()}}));
    }

    /// The whole UTF-8 character at the position.
    std::string_view character() const {
        std::size_t length = 1;
        while (length < rest().size() && core::continues_utf8(rest()[length])) ++length;
        return rest().substr(0, length);
    }

    void skip_blanks() { position_ = std::min(text_.find_first_not_of(core::ascii_blanks, position_), text_.size()); }

    bool accept(std::string_view token) {
        if (!rest().starts_with(token)) return false;
        position_ += token.size();
        skip_blanks();
        return true;
    }

    bool accept_minus() { return accept("-") || accept(minus_sign); }

    /// The run of letters at the position, in lower case.
    std::string name() const {
        std::string result;
        for (const char c : rest()) {
            if (!core::is_letter(c)) break;
            result.push_back(static_cast<char>(c | 0x20));
        }
        return result;
    }

    bool accept_name(std::string_view wanted) {
        if (name() != wanted) return false;
        position_ += wanted.size();
        skip_blanks();
        return true;
    }

    Value sum() {
        Value value = product();
        while (value) {
            const bool adds = accept("+");
            if (!adds && !accept_minus()) break;
            Value next = product();
            if (!next) return next;
            value = *value + (adds ? *next : -*next);
        }
        return value;
    }

    /// A unit counts for the whole product before it: 1/3 deg is a third of a degree.
    Value product() {
        Value value = signed_operand();
        bool has_unit = accept_unit(value);
        while (value) {
            const bool multiplies = accept("*");
            if (!multiplies && !accept("/")) break;
            Value next = signed_operand();
            if (!next) return next;
            if (!multiplies && in_radians(*next) == 0.0) return fail("a division by zero has no value");
            value = multiplies ? *value * *next : *value / *next;
            if (!accept_unit(value)) continue;
            if (has_unit) return fail("a product has two units; parentheses are needed, as in (90 deg)/(30 deg)");
            has_unit = true;
        }
        return value;
    }

    bool accept_unit(Value& value) {
        if (!value) return false;
        if (accept_name("deg") || accept("°")) {
            value = *value * Quantity{0.0, 1.0};
            return true;
        }
        if (!accept_name("rad")) return accept_length_unit(value);
        value = *value * Quantity{0.0, 180.0 / std::numbers::pi};
        return true;
    }

    bool accept_length_unit(Value& value) {
        const auto unit =
            name() == "in" ? std::optional(core::LengthUnit::inch) : core::value_named<core::LengthUnit>(name());
        if (!unit) return false;
        if (lengths_ == nullptr) {
            value = fail(core::sentence("“{unit}” cannot be read here; only lengths of a document with a unit have one",
                                        {{"unit", name()}}));
            return true;
        }
        accept_name(name());
        value = Quantity{core::converted(in_radians(*value), *unit, lengths_->unit) * lengths_->scale};
        return true;
    }

    Value signed_operand() {
        if (depth_ >= deepest) return fail("too many parentheses or signs inside one another");
        ++depth_;
        Value value = accept_minus() ? negated() : accept("+") ? signed_operand() : power();
        --depth_;
        return value;
    }

    Value negated() {
        Value value = signed_operand();
        if (value) value = -*value;
        return value;
    }

    Value power() {
        Value base = operand();
        if (!base || !accept("^")) return base;
        Value exponent = signed_operand();
        if (!exponent) return exponent;
        const double result = std::pow(in_radians(*base), in_radians(*exponent));
        if (std::isfinite(result)) return Quantity{result};
        return fail(core::sentence(
            in_radians(*base) < 0.0 ? "({base})^{exponent} has no value" : "{base}^{exponent} has no value",
            {{"base", core::shortest_text(in_radians(*base))},
             {"exponent", core::shortest_text(in_radians(*exponent))}}));
    }

    Value operand() {
        if (accept("(")) return parenthesized();
        if (accept_name("pi") || accept("π")) return Quantity{std::numbers::pi};
        return name().empty() ? number() : applied_function();
    }

    Value parenthesized() {
        Value value = sum();
        if (value && !accept(")")) return rest().empty() ? fail("a closing parenthesis is missing") : unexpected();
        return value;
    }

    Value applied_function() {
        const std::string called = name();
        const QuantityFunction function = quantity_function(called);
        if (function == nullptr)
            return fail(
                core::sentence("“{name}” is not known; pi, deg, rad, sqrt, sin, cos, tan, asin, acos, atan, "
                               "exp, ln and abs are",
                               {{"name", rest().substr(0, called.size())}}));
        accept_name(called);
        if (!accept("("))
            return fail(core::sentence("{name} needs parentheses, as in {name}(0.5)", {{"name", called}}));
        Value argument = parenthesized();
        if (!argument) return argument;
        const Quantity result = function(*argument);
        if (std::isfinite(in_radians(result))) return result;
        return fail(core::sentence("{name}({argument}) has no value",
                                   {{"name", called}, {"argument", core::shortest_text(in_radians(*argument))}}));
    }

    Value number() {
        if (rest().empty()) return fail("a number is missing at the end");
        if (rest().front() == ')') return fail("a number is missing before the closing parenthesis");
        const std::string_view found = rest().substr(0, rest().find_first_not_of(digits_and_marks));
        if (found.empty()) return unexpected();
        if (std::count_if(found.begin(), found.end(), [](char c) { return c == '.' || c == ','; }) > 1)
            return fail(core::sentence("“{number}” has several points or commas; one is allowed, before the decimals",
                                       {{"number", found}}));
        if (found.back() == ',' && found.size() < rest().size())
            return fail(core::sentence("“{number}” has no decimals after its comma", {{"number", found}}));
        return plain_number();
    }

    /// Decimals may stand after a comma.
    Value plain_number() {
        constexpr std::size_t longest_exponent = 8;
        const std::size_t mantissa = std::min(rest().find_first_not_of(digits_and_marks), rest().size());
        std::string text(rest().substr(0, mantissa + longest_exponent));
        if (const std::size_t comma = text.find(','); comma < mantissa) text[comma] = '.';
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const auto length = static_cast<std::size_t>(end - text.data());
        if (error == std::errc::result_out_of_range)
            return fail(
                core::sentence("“{number}” is outside the range of numbers", {{"number", rest().substr(0, length)}}));
        if (error != std::errc{}) return unexpected();
        position_ += length;
        skip_blanks();
        return Quantity{value};
    }

    std::string_view text_;
    const core::DocumentUnits* lengths_;
    std::size_t position_ = 0;
    int depth_ = 0;
};

std::string_view without_brackets(std::string_view text) {
    const bool has_brackets = text.size() >= 2 && ((text.front() == '[' && text.back() == ']') ||
                                                   (text.front() == '{' && text.back() == '}'));
    return has_brackets ? core::trimmed(text.substr(1, text.size() - 2)) : text;
}

/// The entries of a list; between separators an entry may be empty, while a run of blanks separates once. A last
/// separator ends the last entry.
std::vector<std::string_view> entries_of(std::string_view text) {
    const bool has_separators = find_outside_parentheses(text, ",;") != std::string_view::npos;
    const std::string_view separators = has_separators ? ",;" : core::ascii_blanks;
    std::vector<std::string_view> entries;
    while (!text.empty()) {
        const std::size_t end = find_outside_parentheses(text, separators);
        entries.push_back(core::trimmed(text.substr(0, end)));
        text = end == std::string_view::npos ? std::string_view() : core::trimmed(text.substr(end + 1));
    }
    return entries;
}

}  // namespace

std::size_t find_outside_parentheses(std::string_view text, std::string_view separators) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (depth <= 0 && separators.find(text[i]) != std::string_view::npos) return i;
        depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    }
    return std::string_view::npos;
}

std::string typed_over(std::string_view typed, std::string_view present) {
    const std::string_view text = core::trimmed(typed);
    if (core::trimmed(present).empty()) return std::string(typed);
    for (const std::string_view sign : {"+=", "-=", "\u2212=", "*=", "/=", "^="})
        if (text.starts_with(sign))
            return fmt::format("({}){}({})", present, sign.substr(0, sign.size() - 1), text.substr(sign.size()));
    return std::string(typed);
}

tl::expected<double, std::string> parse_expression(std::string_view text, ExpressionUnit unit,
                                                   const core::DocumentUnits* lengths) {
    const Value value = Parser(text, lengths).parse();
    if (!value) return tl::make_unexpected(value.error());
    const double number = unit == ExpressionUnit::degrees ? in_degrees(*value) : in_radians(*value);
    if (!std::isfinite(number)) return tl::make_unexpected("the result is too large for a number");
    return number;
}

tl::expected<std::vector<double>, std::string> parse_expressions(std::string_view text,
                                                                 const core::DocumentUnits* lengths) {
    std::vector<double> values;
    for (const std::string_view entry : entries_of(without_brackets(core::trimmed(text)))) {
        const auto value = parse_expression(entry, ExpressionUnit::number, lengths);
        if (!value)
            return tl::make_unexpected(
                core::sentence("entry {index}: {problem}", {{"index", values.size()}, {"problem", value.error()}}));
        values.push_back(*value);
    }
    return values;
}

}  // namespace batten::editor
