/// Points from tables as people have them: pasted from a spreadsheet, CSV files, coordinates of airfoils.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/names.h"
#include "core/document/file_text.h"

namespace batten::core {

/// What stands between two cells of a line.
enum class TableSeparator { tab, semicolon, comma, blank };

/// Which columns hold x and y, counted from 1.
struct TableColumns {
    std::size_t x = 1;
    std::size_t y = 2;
};

struct PointTable {
    std::vector<Point> points;
    std::string title;                  ///< a line above the numbers that names no columns, as of an airfoil
    std::vector<std::string> headings;  ///< of the columns; empty where the table has none
    std::size_t column_count = 0;       ///< of the first line with numbers
    TableColumns columns;               ///< those that were read
    TableSeparator separator = TableSeparator::tab;
    bool has_decimal_commas = false;
    bool is_two_sided = false;     ///< the two sides of an airfoil, each from its nose, became one way around it
    std::size_t other_rows = 0;    ///< that were left out, since they are of other curves than the first one
    std::size_t other_curves = 0;  ///< how many these are
};

/// The points in `text`, one a line. Between cells stand tabs, semicolons, commas or blanks, and decimals have a point
/// or a comma: which of them, the whole table decides, as what makes most of its lines numbers throughout. That 1,234
/// has a decimal comma is believed between semicolons, or where a cell like 0,5 or 12,34 tells. Cells may be quoted.
/// Left out are empty lines, what stands behind #, and headings: lines above the numbers that have names and no number,
/// where a name may be Na or Inf, all above one that names x and y but rows of numbers, and between blanks a title like
/// NACA 2412 in the first line. `columns` left out are those with the headings x and y, in any case, else the first two
/// that hold numbers. An airfoil may be given around (Selig), or as two numbers of points and then its upper and its
/// lower side from the nose (Lednicer); the latter becomes the former. Line ends of all systems, a byte order mark,
/// typographic minus signs and blanks do no harm. Of samples of a curve, in a table with a column u, a place that has
/// two rows is one point; in a table with a column curve the first rows count, up to another name in it or a smaller u;
/// an empty cell repeats the name above it, where u, if there is one, increases.
///
/// The error names line and column: a cell that is empty or no finite number, also nan or #N/A in the first row, or one
/// that has thousands separators or may have, or more than one number; a first line that alone begins with a name
/// in front of numbers, which may be that of a column or of a point; a column that the line does not have; or a line of
/// numbers with more columns than there are headings, where these are x and y or stand between commas, or, between
/// commas or blanks, with others than the first one. Or there are no two columns of numbers. Cost O(n).
[[nodiscard]] FileResult<PointTable> read_point_table(std::string_view text,
                                                      std::optional<TableColumns> columns = std::nullopt);

/// What is to be said where the table has rows of other curves than that of the first one, which were left out: a
/// sentence with their number. Empty where it has none.
std::string told_of_other_curves(const PointTable& table);

template <>
struct Names<TableSeparator> {
    using enum TableSeparator;
    static constexpr std::array table{Named{tab, "tab", "tabs"}, Named{semicolon, "semicolon", "semicolons"},
                                      Named{comma, "comma", "commas"}, Named{blank, "blank", "blanks"}};
};

}  // namespace batten::core
