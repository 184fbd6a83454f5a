/// The lines and cells of a table of numbers, and by what they are told apart.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/document/point_table.h"

namespace batten::core {

struct TableDialect {
    TableSeparator separator = TableSeparator::comma;
    bool has_decimal_commas = false;
};

/// A line that holds something, and its number from 1.
struct TableLine {
    std::string_view text;
    std::size_t number = 1;
};

/// `text` without a byte order mark, with hyphens for typographic minus signs and plain blanks for others.
std::string with_plain_signs(std::string_view text);

/// The lines that are not empty, without what stands behind a # that is not quoted and does not begin a sign like #N/A.
std::vector<TableLine> lines_of(std::string_view text);

/// The cells of a line, without blanks and quotation marks around them and without empty ones at the end.
void split(std::string_view line, TableSeparator separator, std::vector<std::string_view>& cells);

/// What makes most lines numbers throughout, else what finds two numbers in most of them, where also what is meant as a
/// number counts. Decimal commas need one that cannot separate thousands, but between semicolons.
TableDialect dialect_of(const std::vector<TableLine>& lines);

}  // namespace batten::core
