#include "core/document/point_table.h"

#include <algorithm>
#include <cmath>

#include "core/base/sentence.h"
#include "core/document/detail/table_cells.h"

namespace batten::core {

namespace {

// Short enough for a sentence, and safe to print.
std::string quoted(std::string_view cell) {
    constexpr std::size_t longest = 40;
    std::string text(cell.substr(0, longest));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text;
}

FileError error_at(std::size_t line, std::size_t column, std::string what) {
    return {sentence("line {line}, column {column}", {{"line", line}, {"column", column}}), std::move(what)};
}

bool begins_with_letter(std::string_view line) {
    const char c = line[line.find_first_not_of(" \t")];
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '"' || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

// Goes through the lines of a table whose dialect is known.
class PointReader {
  public:
    PointReader(const std::vector<TableLine>& lines, TableDialect dialect, std::optional<TableColumns> columns)
        : lines_(lines), dialect_(dialect), asked_(columns) {
        table_.separator = dialect.separator;
        table_.has_decimal_commas = dialect.has_decimal_commas;
    }

    FileResult<PointTable> read() {
        const std::size_t first = skip_headings();
        if (first == lines_.size()) return tl::unexpected(no_numbers());
        if (auto chosen = choose_columns(first); !chosen) return tl::unexpected(chosen.error());
        table_.points.reserve(lines_.size() - first);
        const std::size_t parameter = column_named('u');
        for (std::size_t i = first; i < lines_.size(); ++i) {
            auto point = point_of(lines_[i]);
            if (!point) return tl::unexpected(point.error());
            if (!is_other_side(*point, parameter)) table_.points.push_back(*point);
        }
        join_sides();
        return std::move(table_);
    }

  private:
    std::size_t count_numbers(std::string_view line) {
        split(line, dialect_.separator, cells_);
        return static_cast<std::size_t>(std::count_if(cells_.begin(), cells_.end(), [&](std::string_view cell) {
            return number_in(cell, dialect_.has_decimal_commas).has_value();
        }));
    }

    std::size_t cell_count(std::size_t line) {
        split(lines_[line].text, dialect_.separator, cells_);
        return cells_.size();
    }

    // Whether line `i`, with none but headings above, is one: it lacks two numbers, or it begins with a word and has
    // other cells than the line below, like NACA 23 012.
    bool is_heading(std::size_t i) {
        const std::string_view line = lines_[i].text;
        const std::size_t numbers = count_numbers(line);
        if (numbers >= 2)
            return i + 1 < lines_.size() && begins_with_letter(line) && cells_.size() != cell_count(i + 1);
        return numbers == 0 || begins_with_letter(line);
    }

    std::size_t skip_headings() {
        std::size_t first = 0;
        while (first < lines_.size() && is_heading(first)) ++first;
        if (first == lines_.size()) return first;
        table_.column_count = cell_count(first);
        for (std::size_t i = 0; i < first; ++i) take_heading(lines_[i].text);
        return first;
    }

    void take_heading(std::string_view line) {
        split(line, dialect_.separator, cells_);
        if (cells_.size() == table_.column_count && !is_title())
            table_.headings.assign(cells_.begin(), cells_.end());
        else if (table_.title.empty())
            table_.title = line.substr(line.find_first_not_of(" \t"));
    }

    // Blanks stand within the name of an airfoil, CLARK Y, as between the names of columns, x y: the name has capitals
    // or digits in words.
    bool is_title() const {
        return dialect_.separator == TableSeparator::blank &&
               std::any_of(cells_.begin(), cells_.end(), [](std::string_view word) {
                   return word.size() > 1 &&
                          word.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789") != std::string_view::npos;
               });
    }

    FileError no_numbers() const {
        return {"", "no line with two numbers was found; a table of points has x and y in two of its columns"};
    }

    // The column whose heading is this letter, small or capital, from 1; 0 where there is none.
    std::size_t column_named(char letter) const {
        const auto is_name = [letter](const std::string& heading) {
            return heading.size() == 1 && (heading[0] | 0x20) == letter;
        };
        const auto found = std::find_if(table_.headings.begin(), table_.headings.end(), is_name);
        return found == table_.headings.end() ? 0 : static_cast<std::size_t>(found - table_.headings.begin()) + 1;
    }

    std::optional<TableColumns> named_columns() const {
        const TableColumns named{column_named('x'), column_named('y')};
        return named.x != 0 && named.y != 0 ? std::optional(named) : std::nullopt;
    }

    FileResult<void> choose_columns(std::size_t first) {
        if (asked_) {
            table_.columns = *asked_;
            return {};
        }
        if (const auto named = named_columns()) {
            table_.columns = *named;
            return {};
        }
        split(lines_[first].text, dialect_.separator, cells_);
        std::vector<std::size_t> found;
        for (std::size_t c = 0; c < cells_.size(); ++c)
            if (number_in(cells_[c], dialect_.has_decimal_commas)) found.push_back(c + 1);
        if (found.size() >= 2)
            table_.columns = {found[0], found[1]};
        else if (cells_.size() < 2)
            return tl::unexpected(FileError{sentence("line {line}", {{"line", lines_[first].number}}),
                                            "there is one column; x and y in two columns are needed"});
        return {};
    }

    FileResult<Point> point_of(const TableLine& line) {
        split(line.text, dialect_.separator, cells_);
        const FileResult<double> x = number_at(line, table_.columns.x);
        if (!x) return tl::unexpected(x.error());
        return number_at(line, table_.columns.y).map([&](double y) { return Point(*x, y); });
    }

    // Whether this row, whose cells were read last, has the place of the row before it, as tables of samples have both
    // sides of a knot at which a derivative jumps.
    bool is_other_side(Point point, std::size_t parameter) {
        if (parameter == 0 || parameter > cells_.size()) return false;
        const auto u = number_in(cells_[parameter - 1], dialect_.has_decimal_commas);
        constexpr double rounding = 1e-12;  // of each side by itself
        const bool is_same =
            u && u == last_parameter_ && !table_.points.empty() &&
            distance(table_.points.back(), point) <= rounding * (std::abs(point.x) + std::abs(point.y));
        last_parameter_ = u;
        return is_same;
    }

    FileResult<double> number_at(const TableLine& line, std::size_t column) const {
        if (column == 0 || column > cells_.size())
            return tl::unexpected(error_at(
                line.number, column,
                sentence({.one = "the line has one column", .many = "the line has {count} columns"}, cells_.size())));
        const std::string_view cell = cells_[column - 1];
        if (const auto number = number_in(cell, dialect_.has_decimal_commas)) return *number;
        if (cell.empty()) return tl::unexpected(error_at(line.number, column, "the cell is empty; a number is needed"));
        const char* pattern = dialect_.has_decimal_commas
                                  ? "'{found}' is not a finite number; this table has decimal commas"
                                  : "'{found}' is not a finite number; this table has decimal points";
        return tl::unexpected(error_at(line.number, column, sentence(pattern, {{"found", quoted(cell)}})));
    }

    // Lednicer's form begins with the numbers of points above and below.
    void join_sides() {
        std::vector<Point>& points = table_.points;
        if (points.empty()) return;
        const Point counts = points.front();
        const bool are_counts = counts.x >= 2.0 && counts.y >= 2.0 && std::trunc(counts.x) == counts.x &&
                                std::trunc(counts.y) == counts.y &&
                                counts.x + counts.y == static_cast<double>(points.size() - 1);
        if (!are_counts) return;
        points.erase(points.begin());
        const auto lower = points.begin() + static_cast<std::ptrdiff_t>(counts.x);
        std::reverse(points.begin(), lower);
        if (*lower == *std::prev(lower)) points.erase(lower);
        table_.is_two_sided = true;
    }

    const std::vector<TableLine>& lines_;
    TableDialect dialect_;
    std::optional<TableColumns> asked_;
    PointTable table_;
    std::vector<std::string_view> cells_;
    std::optional<double> last_parameter_{};
};

}  // namespace

FileResult<PointTable> read_point_table(std::string_view text, std::optional<TableColumns> columns) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        return tl::unexpected(FileError{"", "the text is UTF-16; UTF-8 is needed, as spreadsheets save CSV"});
    const std::string plain = with_plain_signs(text);
    const std::vector<TableLine> lines = lines_of(plain);
    return PointReader(lines, dialect_of(lines), columns).read();
}

}  // namespace batten::core
