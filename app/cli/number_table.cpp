#include "app/cli/number_table.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/ascii.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::cli {

namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::string_view separators = " \t\r,;";

bool is_blank(char c) {
    return blanks.find(c) != std::string_view::npos;
}

bool is_separator(char c) {
    return separators.find(c) != std::string_view::npos;
}

void skip_blanks(std::string_view& rest) {
    while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
}

// What stands at the front of `rest` up to the next separator, or a separator.
std::string_view entry_at(std::string_view rest) {
    return rest.substr(0, std::max<std::size_t>(1, std::min(rest.find_first_of(separators), rest.size())));
}

// Short enough for a sentence, and safe to print.
std::string quoted(std::string_view entry) {
    constexpr std::size_t longest = 40;
    std::string text(entry.substr(0, longest));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text;
}

// A name begins with a letter or a quotation mark; nan and inf are meant as numbers.
bool is_name(std::string_view entry) {
    constexpr std::array numbers{"nan", "inf", "infinity"};
    const std::string word = core::in_small_letters(entry);
    const bool begins_so = (word.front() >= 'a' && word.front() <= 'z') || word.front() == '"' || word.front() == '_';
    return begins_so && std::find(numbers.begin(), numbers.end(), word) == numbers.end();
}

bool is_heading(std::string_view line) {
    for (skip_blanks(line); !line.empty(); skip_blanks(line)) {
        const std::string_view entry = entry_at(line);
        if (!is_separator(entry.front()) && !is_name(entry)) return false;
        line.remove_prefix(entry.size());
    }
    return true;
}

// Goes through the lines and collects their numbers.
class TableReader {
  public:
    core::FileResult<std::vector<double>> read(std::string_view text) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
        for (; !text.empty() && error_.empty(); ++number_) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            read_line(text.substr(0, end));
            text.remove_prefix(std::min(end + 1, text.size()));
        }
        if (error_.empty()) return std::move(numbers_);
        return tl::unexpected(core::FileError{core::sentence("line {number}", {{"number", number_ - 1}}), error_});
    }

  private:
    void read_line(std::string_view line) {
        line = line.substr(0, line.find('#'));
        skip_blanks(line);
        if (line.empty()) return;
        const bool may_be_heading = std::exchange(may_be_heading_, false);
        if (may_be_heading && is_heading(line)) return;
        read_numbers(line);
    }

    void read_numbers(std::string_view rest) {
        char separator = '\0';
        while (!rest.empty()) {
            const auto number = core::leading_number(rest);
            const bool is_whole = number && (number->length == rest.size() || is_separator(rest[number->length]));
            if (!is_whole) return refuse(entry_at(rest));
            rest.remove_prefix(number->length);
            numbers_.push_back(number->value);
            const char next = take_separator(rest);
            if (separator != '\0' && !rest.empty() && next != separator) return refuse_separators();
            separator = next;
        }
    }

    // The comma or semicolon behind a number, or a blank where there is neither.
    static char take_separator(std::string_view& rest) {
        skip_blanks(rest);
        if (rest.empty() || (rest.front() != ',' && rest.front() != ';')) return ' ';
        const char separator = rest.front();
        rest.remove_prefix(1);
        skip_blanks(rest);
        return separator;
    }

    void refuse(std::string_view entry) {
        error_ = core::sentence(
            "'{found}' cannot be read here; finite numbers with a decimal point are needed, separated by commas, "
            "semicolons or blanks, and # begins a comment",
            {{"found", quoted(entry)}});
    }

    void refuse_separators() {
        error_ = "the numbers are separated in two ways; one of commas, semicolons and blanks is allowed on a line";
    }

    std::vector<double> numbers_;
    std::size_t number_ = 1;
    bool may_be_heading_ = true;
    std::string error_;
};

}  // namespace

core::FileResult<std::vector<double>> parse_table(std::string_view text) {
    return TableReader().read(text);
}

}  // namespace batten::cli
