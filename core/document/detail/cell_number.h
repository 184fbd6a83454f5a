/// What stands in a cell of a table: a number, something in the place of one, or a name.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace batten::core {

/// The number that is all of `cell`.
std::optional<double> number_in(std::string_view cell, bool has_decimal_commas);

/// Whether the # of `line` at `place` begins no comment but what a spreadsheet or printf writes in the place of a
/// number: #N/A, #DIV/0!, or 1.#INF.
bool begins_error_sign(std::string_view line, std::size_t place);

/// Whether the cell stands in the place of a number that is none: "nan", "-inf", "NA", "#N/A", "#DIV/0!".
bool means_no_number(std::string_view cell);

/// Whether the cell is a number with thousands separators for certain: "1,234.5", "1.234.567", "1 234,5", "1'234";
/// not "1.5,5".
bool has_thousands(std::string_view cell);

/// Whether a comma in the cell may separate thousands as well as decimals, since three digits follow it: "3,000", not
/// "0,250".
bool may_have_thousands(std::string_view cell);

/// Whether the cell holds more than one number, as where separators of two kinds stand between numbers: "2.5 3.5",
/// "1.5,5", not "1,5".
bool has_several_numbers(std::string_view cell);

/// Whether the cell is a number with points, with commas or with thousands separators, or holds more than one.
bool has_number(std::string_view cell);

}  // namespace batten::core
