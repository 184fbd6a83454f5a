/// The languages of code_of(), one source each, and what they share.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "exchange/code/code.h"
#include "exchange/path_pieces.h"

namespace batten::exchange {

std::string latex_text(const core::DocumentCurve& entry);
std::string tikz_text(const core::DocumentCurve& entry, const PathPieces& pieces);
std::string cpp_text(const core::DocumentCurve& entry);
std::string python_text(const core::DocumentCurve& entry);
std::string matlab_text(const core::DocumentCurve& entry);

/// One line that says in a comment what follows: "'wave': a B-spline curve of degree 3 over [0, 1]".
std::string heading(const core::DocumentCurve& entry);

/// The number as it stands in programs, with a sign also for zero: "-0.0", "1e-300".
std::string code_number(double value);

/// The texts of the numbers, so many of them in a line, with commas between.
std::string code_numbers(std::span<const double> values, std::size_t in_a_line = 10);

/// The same for points, each as `text` makes it.
std::string code_points(std::span<const core::Point> points, const std::function<std::string(core::Point)>& text);

}  // namespace batten::exchange
