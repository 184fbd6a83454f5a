/// Numbers and formulas as text, in the label notation of render::Label.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/evaluate/de_boor.h"

namespace batten::editor {

/// The sign that people read; files, logs and the command line have '-'.
inline constexpr const char* true_minus = "−";

/// `digits` (1..17) significant digits, without trailing zeros, "−" for minus; a whole part is never rounded to fewer
/// digits than it has. "1e−12" style below 1e-4 and from 1e6 (or from 10^digits if that is more).
std::string number_text(double value, int digits = 4);

/// number_text of what something is "at most", >= 0: rounded up, so that the text is no less than `value` but for its
/// last bits.
std::string bound_text(double value, int digits = 4);

/// "0.5" for "0.500".
std::string without_trailing_zeros(std::string text);

/// Exactly `decimals` digits after the point, "−" for minus, never "−0": for columns.
std::string fixed_text(double value, int decimals);

/// "P_{3}^{1}", for level 0 "P_{3}", for the last level "C(u)". `index` is the place in the level, not the i of P_i.
/// Pass the number of control points of a periodic curve, so that level 0 names the points as the canvas does (i mod
/// n); the other levels keep the numbering of the unrolled points and knots, which their formulas need.
std::string cell_text(const core::DeBoorTriangle& triangle, std::size_t level, std::size_t index,
                      std::size_t point_count = std::numeric_limits<std::size_t>::max());

/// The two lines "α_{3}^{1} = (u − u_{3})/(u_{6} − u_{3})" and "= (0.4 − 0)/(0.75 − 0) = 8/15", for level >= 1.
/// Negative numbers that are subtracted stand in parentheses; knots closer than four digits tell are written with more.
struct AlphaFormula {
    std::string symbols;
    std::string numbers;
};
AlphaFormula alpha_formula(const core::Curve& curve, const core::DeBoorTriangle& triangle, std::size_t level,
                           std::size_t index);

/// "P_{3}^{1} = (1 − α) P_{2} + α P_{3}", for level >= 1; `point_count` as for cell_text.
std::string cell_formula(const core::DeBoorTriangle& triangle, std::size_t level, std::size_t index,
                         std::size_t point_count = std::numeric_limits<std::size_t>::max());

/// "P₅".
std::string point_text(std::size_t index);

/// "P₅", or "3 points".
std::string points_text(const std::vector<std::size_t>& indices);

/// "C^{2}", or "jump" for -1.
std::string continuity_text(int continuity);

/// The label notation as plain Unicode, "P₃¹", for tool tips, history and status bar. Digits, signs and commas have
/// such glyphs; a group with anything else stays in parentheses, "C^{p−m}" as "C(p−m)".
std::string plain_text(const std::string& label);

}  // namespace batten::editor
