#include "core/document/detail/table_cells.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/ascii.h"
#include "core/document/detail/cell_number.h"

namespace batten::core {

namespace {

std::string_view unquoted(std::string_view cell) {
    if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return cell;
    return trimmed(cell.substr(1, cell.size() - 2));
}

char sign_of(TableSeparator separator) {
    switch (separator) {
        case TableSeparator::tab:
            return '\t';
        case TableSeparator::semicolon:
            return ';';
        case TableSeparator::comma:
            return ',';
        case TableSeparator::blank:
            break;
    }
    return ' ';
}

// Where the cell at the front of `line` ends: at the next separator that is not quoted.
std::size_t end_of_cell(std::string_view line, char sign) {
    bool is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') is_quoted = !is_quoted;
        const bool is_separator = line[i] == sign || (sign == ' ' && line[i] == '\t');
        if (is_separator && !is_quoted) return i;
    }
    return line.size();
}

// What a text may have in place of plain signs.
struct SignRow {
    std::string_view typographic;
    std::string_view plain;
};
constexpr std::array sign_rows{SignRow{"\xEF\xBB\xBF", ""}, SignRow{"\xE2\x88\x92", "-"}, SignRow{"\xC2\xA0", " "},
                               SignRow{"\xE2\x80\xAF", " "}, SignRow{"\xE2\x80\x89", " "}};

std::string_view without_comment(std::string_view line) {
    bool is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') is_quoted = !is_quoted;
        if (line[i] == '#' && !is_quoted && !begins_error_sign(line, i)) return line.substr(0, i);
    }
    return line;
}

// What means a number in this dialect, be it one that is not read.
bool counts_as_number(std::string_view cell, TableDialect dialect) {
    if (number_in(cell, dialect.has_decimal_commas) || means_no_number(cell) || has_thousands(cell)) return true;
    return dialect.separator != TableSeparator::semicolon && !dialect.has_decimal_commas && may_have_thousands(cell);
}

bool proves_decimal_commas(std::string_view cell) {
    return cell.find(',') != std::string_view::npos && number_in(cell, true) && !may_have_thousands(cell);
}

// Lines of numbers throughout count most.
std::size_t score_of(const std::vector<TableLine>& lines, TableDialect dialect) {
    std::vector<std::string_view> cells;
    std::size_t score = 0;
    bool is_proven = !dialect.has_decimal_commas || dialect.separator == TableSeparator::semicolon;
    for (const TableLine& line : lines) {
        split(line.text, dialect.separator, cells);
        const auto numbers = static_cast<std::size_t>(
            std::ranges::count_if(cells, [&](std::string_view cell) { return counts_as_number(cell, dialect); }));
        if (numbers >= 2) score += std::size_t{numbers == cells.size() ? 2U : 1U};
        is_proven = is_proven || std::ranges::any_of(cells, proves_decimal_commas);
    }
    return is_proven ? score : 0;
}

bool occurs(const std::vector<TableLine>& lines, char sign) {
    return std::any_of(lines.begin(), lines.end(),
                       [sign](const TableLine& line) { return line.text.find(sign) != std::string_view::npos; });
}

}  // namespace

std::string with_plain_signs(std::string_view text) {
    std::string plain;
    plain.reserve(text.size());
    while (!text.empty()) {
        const auto* const row = static_cast<unsigned char>(text.front()) < 0x80
                                    ? sign_rows.end()
                                    : std::find_if(sign_rows.begin(), sign_rows.end(),
                                                   [&](auto sign) { return text.starts_with(sign.typographic); });
        plain += row == sign_rows.end() ? text.substr(0, 1) : row->plain;
        text.remove_prefix(row == sign_rows.end() ? 1 : row->typographic.size());
    }
    return plain;
}

std::vector<TableLine> lines_of(std::string_view text) {
    std::vector<TableLine> lines;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = text.substr(0, end);
        lines.push_back({without_comment(line), number});
        const std::size_t length_of_end = text.substr(end).starts_with("\r\n") ? 2 : 1;
        text.remove_prefix(std::min(end + length_of_end, text.size()));
    }
    // Lines of mere separators are empty rows of a spreadsheet. Tabs at the front stand for empty cells.
    std::erase_if(
        lines, [](const TableLine& line) { return line.text.find_first_not_of(" \t,;\"") == std::string_view::npos; });
    return lines;
}

void split(std::string_view line, TableSeparator separator, std::vector<std::string_view>& cells) {
    cells.clear();
    const char sign = sign_of(separator);
    if (separator == TableSeparator::blank) line = trimmed(line);
    while (true) {
        const std::size_t end = end_of_cell(line, sign);
        cells.push_back(unquoted(trimmed(line.substr(0, end))));
        if (end == line.size()) break;
        line.remove_prefix(end + 1);
        if (separator == TableSeparator::blank) line = trimmed(line);
    }
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
}

TableDialect dialect_of(const std::vector<TableLine>& lines) {
    using enum TableSeparator;
    constexpr std::array<TableDialect, 8> all{{{tab, false},
                                               {tab, true},
                                               {semicolon, false},
                                               {semicolon, true},
                                               {comma, false},
                                               {blank, false},
                                               {blank, true},
                                               {comma, true}}};
    std::optional<TableDialect> best;
    std::size_t most = 0;
    for (const TableDialect dialect : all) {
        if (dialect.separator != blank && !occurs(lines, sign_of(dialect.separator))) continue;
        const std::size_t score = score_of(lines, dialect);
        if (best && score <= most) continue;
        most = score;
        best = dialect;
    }
    return best.value_or(TableDialect{});
}

}  // namespace batten::core
