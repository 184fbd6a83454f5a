#include "core/document/point_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/ascii.h"
#include "core/base/sentence.h"
#include "core/document/detail/cell_number.h"
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

// Whether it does not begin as numbers do, and stands in the place of none.
bool is_name(std::string_view cell) {
    return !cell.empty() && std::string_view("0123456789+-.,").find(cell.front()) == std::string_view::npos &&
           !means_no_number(cell);
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
        parameter_column_ = column_named("u");
        curve_column_ = column_named("curve");
        for (std::size_t i = first; i < lines_.size(); ++i) {
            split(lines_[i].text, dialect_.separator, cells_);
            if (auto taken = take_row(lines_[i]); !taken) return tl::unexpected(taken.error());
        }
        join_sides();
        return std::move(table_);
    }

  private:
    std::size_t cell_count(std::size_t line) {
        split(lines_[line].text, dialect_.separator, cells_);
        return cells_.size();
    }

    // Whether line `i`, with none but headings above, is one.
    bool is_heading(std::size_t i) {
        split(lines_[i].text, dialect_.separator, cells_);
        const auto numbers = static_cast<std::size_t>(std::ranges::count_if(cells_, has_number));
        if (numbers == 0)
            return std::ranges::any_of(cells_, is_name) || (cells_.size() == 1 && !means_no_number(cells_.front()));
        return i == 0 && dialect_.separator == TableSeparator::blank && is_title_with_numbers(numbers);
    }

    // NACA 2412, or NACA 23 012, which has other cells than the line below.
    bool is_title_with_numbers(std::size_t numbers) {
        if (!is_name(cells_.front()) || std::ranges::any_of(cells_, means_no_number)) return false;
        return numbers < 2 || (lines_.size() > 1 && cells_.size() != cell_count(1));
    }

    // How many lines stand above one that names x and y, with it; 0 where one of them is a row, or none names these.
    std::size_t count_to_names() {
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            split(lines_[i].text, dialect_.separator, cells_);
            if (names_x_and_y()) return i + 1;
            if (is_row(i)) break;
        }
        return 0;
    }

    // Whether line `i`, which is split, is of numbers, or of a name and numbers with as many cells as the line below.
    bool is_row(std::size_t i) {
        const std::size_t count = cells_.size();
        if (std::ranges::none_of(cells_, is_name)) return count > 1;
        return std::ranges::count_if(cells_, has_number) > 1 && i + 1 < lines_.size() && cell_count(i + 1) == count;
    }

    std::size_t skip_headings() {
        std::size_t first = count_to_names();
        while (first < lines_.size() && is_heading(first)) ++first;
        if (first == lines_.size()) return first;
        table_.column_count = cell_count(first);
        const bool may_split_thousands =
            dialect_.separator == TableSeparator::comma || dialect_.separator == TableSeparator::blank;
        if (may_split_thousands && are_numbers() && !has_empty_end(lines_[first])) row_width_ = table_.column_count;
        for (std::size_t i = 0; i < first; ++i) take_heading(lines_[i].text);
        return first;
    }

    // What stands below the names x and y, like units, is let go.
    void take_heading(std::string_view line) {
        if (named_columns()) return;
        split(line, dialect_.separator, cells_);
        if (names_x_and_y() || (cells_.size() == table_.column_count && !is_title()))
            table_.headings.assign(cells_.begin(), cells_.end());
        else if (table_.title.empty())
            table_.title = line.substr(line.find_first_not_of(" \t"));
        const bool are_counted = dialect_.separator == TableSeparator::comma || (!asked_ && named_columns());
        heading_count_ = are_counted && cells_.size() >= 2 ? cells_.size() : 0;
    }

    bool names_x_and_y() const {
        return std::ranges::find(cells_, "x", in_small_letters) != cells_.end() &&
               std::ranges::find(cells_, "y", in_small_letters) != cells_.end();
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

    // The column whose heading is `name`, in small letters or capital ones, from 1; 0 where there is none.
    std::size_t column_named(std::string_view name) const {
        const auto found = std::ranges::find(table_.headings, name, in_small_letters);
        return found == table_.headings.end() ? 0 : static_cast<std::size_t>(found - table_.headings.begin()) + 1;
    }

    std::optional<TableColumns> named_columns() const {
        const TableColumns named{column_named("x"), column_named("y")};
        return named.x != 0 && named.y != 0 ? std::optional(named) : std::nullopt;
    }

    // Whether a name, be it that of a column or that of a point, and two numbers stand above lines of numbers.
    bool has_name_above_numbers() {
        split(lines_.front().text, dialect_.separator, cells_);
        if (lines_.size() == 1 || std::ranges::count_if(cells_, has_number) < 2 || !is_name(cells_.front()))
            return false;
        return std::all_of(lines_.begin() + 1, lines_.end(), [&](const TableLine& line) {
            split(line.text, dialect_.separator, cells_);
            return !cells_.empty() && number_in(cells_.front(), dialect_.has_decimal_commas);
        });
    }

    FileResult<void> choose_columns(std::size_t first) {
        if (first == 0 && has_name_above_numbers()) {
            split(lines_[first].text, dialect_.separator, cells_);
            return tl::unexpected(error_at(
                lines_[first].number, 1,
                sentence("'{found}' stands above numbers, and may name its column or its point; a line with x and y "
                         "above the numbers tells which columns are read",
                         {{"found", quoted(cells_.front())}})));
        }
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
            if (has_number(cells_[c]) || means_no_number(cells_[c])) found.push_back(c + 1);
        if (found.size() >= 2)
            table_.columns = {found[0], found[1]};
        else if (cells_.size() < 2)
            return tl::unexpected(FileError{sentence("line {line}", {{"line", lines_[first].number}}),
                                            "there is one column; x and y in two columns are needed"});
        return {};
    }

    // A row is what cells_ has of it.
    FileResult<void> take_row(const TableLine& line) {
        const std::optional<double> last = std::exchange(parameter_, parameter_of_row());
        if (is_of_other_curve(last)) return {};
        const FileResult<double> x = number_at(line, table_.columns.x);
        if (!x) return tl::unexpected(x.error());
        const FileResult<double> y = number_at(line, table_.columns.y);
        if (!y) return tl::unexpected(y.error());
        if (auto error = error_of_width(line)) return tl::unexpected(*std::move(error));
        if (const Point point(*x, *y); !is_other_side(point, last)) table_.points.push_back(point);
        return {};
    }

    std::optional<double> parameter_of_row() const {
        if (parameter_column_ == 0 || parameter_column_ > cells_.size()) return std::nullopt;
        return number_in(cells_[parameter_column_ - 1], dialect_.has_decimal_commas);
    }

    // Curves follow one another. Two of them may have one name, where u begins anew. The name need not be repeated.
    bool is_of_other_curve(std::optional<double> last_parameter) {
        if (curve_column_ == 0) return false;
        const bool is_earlier = parameter_ && last_parameter && *parameter_ < *last_parameter;
        const bool is_later = !parameter_ || !last_parameter || *parameter_ > *last_parameter;
        std::string_view name = curve_column_ > cells_.size() ? std::string_view() : cells_[curve_column_ - 1];
        if (name.empty() && is_later) name = curve_.value_or(name);
        const std::optional<std::string_view> last_name = std::exchange(curve_, name);
        if (last_name && (name != *last_name || is_earlier)) ++table_.other_curves;
        if (table_.other_curves > 0) ++table_.other_rows;
        return table_.other_curves > 0;
    }

    // Commas and blanks that separate thousands make more cells of a row than there are headings, or than other rows
    // have.
    std::optional<FileError> error_of_width(const TableLine& line) const {
        const std::size_t count = cells_.size();
        const std::size_t expected = heading_count_ > 0 ? heading_count_ : row_width_;
        const bool is_too_short = heading_count_ == 0 && count < expected && !has_empty_end(line);
        if (expected == 0 || (count <= expected && !is_too_short) || !are_numbers()) return std::nullopt;
        const char* pattern = heading_count_ > 0 ? "the line has {columns} columns, and there are {expected} headings"
                                                 : "the line has {columns} columns, and the first one has {expected}";
        return error_at(line.number, std::min(count, expected) + 1,
                        sentence(pattern, {{"columns", count}, {"expected", expected}}));
    }

    bool are_numbers() const {
        return std::ranges::all_of(
            cells_, [&](std::string_view cell) { return number_in(cell, dialect_.has_decimal_commas).has_value(); });
    }

    static bool has_empty_end(const TableLine& line) { return trimmed(line.text).ends_with(','); }

    // Whether this row has the place of the row before it, as tables of samples have both sides of a knot at which a
    // derivative jumps.
    bool is_other_side(Point point, std::optional<double> last_parameter) const {
        constexpr double rounding = 1e-12;  // of each side by itself
        return parameter_ && parameter_ == last_parameter && !table_.points.empty() &&
               distance(table_.points.back(), point) <= rounding * (std::abs(point.x) + std::abs(point.y));
    }

    FileResult<double> number_at(const TableLine& line, std::size_t column) const {
        if (column == 0 || column > cells_.size())
            return tl::unexpected(error_at(
                line.number, column,
                sentence({.one = "the line has one column", .many = "the line has {count} columns"}, cells_.size())));
        const std::string_view cell = cells_[column - 1];
        if (const auto number = number_in(cell, dialect_.has_decimal_commas)) return *number;
        if (cell.empty()) return tl::unexpected(error_at(line.number, column, "the cell is empty; a number is needed"));
        return tl::unexpected(
            error_at(line.number, column, sentence(pattern_of_wrong(cell), {{"found", quoted(cell)}})));
    }

    const char* pattern_of_wrong(std::string_view cell) const {
        if (has_thousands(cell)) {
            const bool may_be_two =
                dialect_.separator == TableSeparator::comma && cell.find(' ') != std::string_view::npos;
            return may_be_two ? "'{found}' is more than one number or has thousands separators; each point needs a "
                                "line, with a comma between x and y"
                              : "'{found}' has thousands separators, which are not read";
        }
        if (dialect_.has_decimal_commas) return "'{found}' is not a finite number; this table has decimal commas";
        if (may_have_thousands(cell) && dialect_.separator != TableSeparator::semicolon)
            return "'{found}' may have a decimal comma or separate thousands by it; semicolons between the columns "
                   "tell that commas are decimal";
        if (has_several_numbers(cell))
            return "'{found}' is more than one number; each point needs a line, with one separator between its columns";
        return "'{found}' is not a finite number; this table has decimal points";
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
    std::size_t heading_count_ = 0;  // in the last line above the numbers; 0 where there are none
    std::size_t row_width_ = 0;      // of the first line, of numbers between commas or blanks; 0 for others
    std::size_t parameter_column_ = 0;
    std::size_t curve_column_ = 0;
    std::vector<std::string_view> cells_;
    std::optional<double> parameter_{};        // of this row
    std::optional<std::string_view> curve_{};  // whose row this is
};

}  // namespace

FileResult<PointTable> read_point_table(std::string_view text, std::optional<TableColumns> columns) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        return tl::unexpected(FileError{"", "the text is UTF-16; UTF-8 is needed, as spreadsheets save CSV"});
    const std::string plain = with_plain_signs(text);
    const std::vector<TableLine> lines = lines_of(plain);
    return PointReader(lines, dialect_of(lines), columns).read();
}

std::string told_of_other_curves(const PointTable& table) {
    if (table.other_curves == 0) return {};
    return sentence(
        {.one = "the points are those of the first curve; the rows of another one are left out: {rows}",
         .many = "the points are those of the first curve; the rows of {count} others are left out: {rows}"},
        table.other_curves, {{"rows", table.other_rows}});
}

}  // namespace batten::core
