#include "render/tex_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "render/first_sign.h"
#include "render/label_runs.h"
#include "render/prose.h"
#include "render/tex_signs.h"

namespace batten::render {

namespace {

bool is_digit(std::string_view sign) {
    return sign.size() == 1 && '0' <= sign[0] && sign[0] <= '9';
}

/// What stands in numbers and between words alike.
bool is_plain(std::string_view sign) {
    constexpr std::string_view plain = ".,:;!?";
    return is_digit(sign) || (sign.size() == 1 && plain.find(sign) != std::string_view::npos);
}

/// A Latin letter that all fonts of a stock LaTeX have.
bool is_latin(std::string_view sign) {
    if (sign.size() == 1) return ('a' <= sign[0] && sign[0] <= 'z') || ('A' <= sign[0] && sign[0] <= 'Z');
    constexpr std::string_view rare = "ÐðÞþĐđĸŊŋŉĦħŁŦŧĿŀſĄąĘęĮįŲų×÷";
    return sign.size() == 2 && sign >= "À" && sign <= "ž" && rare.find(sign) == std::string_view::npos;
}

/// The signs from the beginning on that are of one kind.
template <class IsOfKind>
std::string_view first_of(std::string_view text, const IsOfKind& is_of_kind) {
    std::size_t size = 0;
    while (size < text.size() && is_of_kind(first_sign(text.substr(size))))
        size += first_sign(text.substr(size)).size();
    return text.substr(0, size);
}

/// "1/6" where the text begins with it and goes on neither as a decimal nor as another fraction.
std::string_view first_fraction(std::string_view text) {
    const std::string_view upper = first_of(text, is_digit);
    if (upper.empty() || !text.substr(upper.size()).starts_with('/')) return {};
    const std::string_view lower = first_of(text.substr(upper.size() + 1), is_digit);
    const std::string_view rest = text.substr(upper.size() + 1 + lower.size());
    const bool goes_on = rest.starts_with('/') || (rest.starts_with('.') && is_digit(first_sign(rest.substr(1))));
    return lower.empty() || goes_on ? std::string_view() : text.substr(0, text.size() - rest.size());
}

/// Whether words may hold it as it is.
bool is_of_words(std::string_view sign) {
    constexpr std::string_view signs = " +=*/()[]-'`@";
    return is_plain(sign) || (sign.size() == 1 && signs.find(sign) != std::string_view::npos);
}

/// Writes a label, in and out of formulas; of prose, whatever it holds, only signs that words lack are formulas.
class TexWriter {
  public:
    explicit TexWriter(bool is_prose) : is_prose_(is_prose) {}

    void write(const LabelRun& run) {
        if (run.script == Script::none) return write_signs(run.text);
        enter_formula();
        text_ += run.script == Script::sub ? "_{" : "^{";
        is_script_ = true;
        write_signs(run.text);
        is_script_ = false;
        text_ += '}';
    }

    /// A formula as LaTeX has it.
    void write_math(std::string_view formula) {
        leave_formula();
        add("${}$", formula);
    }

    std::string take() {
        leave_formula();
        return std::move(text_);
    }

    /// Those for which LaTeX has no font, one by one.
    std::vector<std::string> take_letters() { return std::move(letters_); }

  private:
    void write_signs(std::string_view rest) {
        bool follows_number = false;
        while (!rest.empty()) {
            const std::string_view taken =
                is_prose_ && !is_script_ ? take_of_prose(rest) : take_first(rest, follows_number);
            follows_number = is_digit(first_sign(taken)) || taken == "." || taken == "/";
            rest.remove_prefix(taken.size());
        }
    }

    /// Writes what stands first and returns it.
    std::string_view take_first(std::string_view rest, bool follows_number) {
        const std::string_view fraction = follows_number ? std::string_view() : first_fraction(rest);
        if (!fraction.empty()) return write_fraction(fraction);
        const std::string_view sign = first_sign(rest);
        const std::string_view word = first_of(rest, is_latin);
        if (word.size() > sign.size() || (!word.empty() && sign.size() > 1)) return write_words(word);
        if (is_plain(sign)) return write_plain(sign, follows_number && is_digit(first_sign(rest.substr(1))));
        if (!word.empty()) return write_formula(sign, sign);
        if (const auto name = math_sign(sign)) return write_math_sign(rest, *name);
        if (sign == " " && is_inside_formula()) return sign;
        if (const auto name = text_sign(sign)) {
            write_words(*name);
            return sign;
        }
        if (sign.size() == 1) return write_words(sign);
        return write_letters(rest);
    }

    std::string_view take_of_prose(std::string_view rest) {
        const std::string_view words =
            first_of(rest, [](std::string_view sign) { return is_latin(sign) || is_of_words(sign); });
        if (!words.empty()) return write_words(words);
        const std::string_view sign = first_sign(rest);
        if (const auto name = text_sign(sign)) {
            write_words(*name);
            return sign;
        }
        if (const auto name = math_sign(sign)) return write_math_sign(rest, *name);
        return sign.size() == 1 ? write_words(sign) : write_letters(rest);
    }

    std::string_view write_math_sign(std::string_view rest, std::string_view name) {
        return is_script(name) ? write_scripts(rest, name.front()) : write_formula(first_sign(rest), name);
    }

    static bool is_script(std::string_view name) { return name.starts_with('^') || name.starts_with('_'); }

    /// "⁻¹" as ^{-1}; on a base of their own where something has a script already, of which it may have one.
    std::string_view write_scripts(std::string_view rest, char kind) {
        enter_formula();
        if (text_.ends_with('}') || text_.ends_with('\'')) add("{{}}");
        text_ += kind;
        text_ += '{';
        std::size_t size = 0;
        while (size < rest.size()) {
            const std::string_view sign = first_sign(rest.substr(size));
            const auto name = math_sign(sign);
            if (!name || name->front() != kind) break;
            text_ += name->substr(1);
            size += sign.size();
        }
        text_ += '}';
        if (rest.substr(size).starts_with("′")) add("{{}}");
        return rest.substr(0, size);
    }

    std::string_view write_fraction(std::string_view fraction) {
        const std::size_t bar = fraction.find('/');
        enter_formula();
        add("\\frac{{{}}}{{{}}}", fraction.substr(0, bar), fraction.substr(bar + 1));
        return fraction;
    }

    std::string_view write_formula(std::string_view sign, std::string_view name) {
        enter_formula();
        text_ += name;
        open_ += sign == "(" ? 1 : sign == ")" ? -1 : 0;
        return sign;
    }

    /// In the formula where one is open, in which a comma has room behind it unless it is a decimal one.
    std::string_view write_plain(std::string_view sign, bool is_in_number) {
        text_ += is_inside_formula() && is_in_number && sign == "," ? "{,}" : sign;
        return sign;
    }

    /// Where blanks are TeX's own.
    bool is_inside_formula() const { return is_script_ || (is_in_formula_ && open_ > 0); }

    std::string_view write_words(std::string_view words) {
        if (!is_script_) leave_formula();
        add(is_script_ ? "\\mathrm{{{}}}" : "{}", words);
        return words;
    }

    std::string_view write_letters(std::string_view rest) {
        const std::string_view letters = first_of(rest, [](std::string_view sign) {
            return sign.size() > 1 && !is_latin(sign) && !math_sign(sign) && !text_sign(sign);
        });
        for (std::string_view left = letters; !left.empty(); left.remove_prefix(first_sign(left).size()))
            letters_.emplace_back(first_sign(left));
        if (!is_script_) leave_formula();
        add(is_script_ ? "\\hbox{{\\battenletters{{{}}}}}" : "\\battenletters{{{}}}", letters);
        return letters;
    }

    template <typename... Values>
    void add(const char* pattern, const Values&... values) {
        text_ += fmt::format(fmt::runtime(pattern), values...);
    }

    void enter_formula() {
        if (!is_in_formula_) text_ += '$';
        is_in_formula_ = true;
    }

    void leave_formula() {
        if (is_in_formula_) text_ += '$';
        is_in_formula_ = false;
    }

    std::string text_;
    std::vector<std::string> letters_;
    bool is_prose_;
    bool is_in_formula_ = false;
    bool is_script_ = false;
    int open_ = 0;  // parentheses
};

}  // namespace

std::string tex_text(std::string_view label) {
    TexWriter writer(false);
    for (const LabelRun& run : label_runs(label)) writer.write(run);
    return writer.take();
}

std::string tex_prose(std::string_view prose) {
    TexWriter writer(true);
    for (const ProsePart& part : prose_parts(prose)) {
        if (part.is_formula) {
            writer.write_math(part.text);
            continue;
        }
        for (const LabelRun& run : label_runs(part.text)) writer.write(run);
    }
    return writer.take();
}

std::vector<std::string> letters_without_tex(std::string_view label) {
    TexWriter writer(true);
    for (const LabelRun& run : label_runs(label)) writer.write(run);
    return writer.take_letters();
}

}  // namespace batten::render
