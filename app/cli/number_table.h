/// Tables of numbers as text: what an argument @FILE stands for where no points are meant.
#pragma once

#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "core/document/file_text.h"

namespace batten::cli {

/// The numbers of `text`, line by line. Those of one line are separated by commas, by semicolons or by blanks, by one
/// of these throughout; decimals have a point. Empty lines are skipped, and so is what stands behind #, and a heading:
/// a first line of nothing but names. The error names the line, what was found and what is allowed.
core::FileResult<std::vector<double>> parse_table(std::string_view text);

}  // namespace batten::cli
