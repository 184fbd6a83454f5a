/// Numbers and formulas as text, in the label notation of render::Label.
#pragma once

#include <string>
#include <vector>

namespace batten::editor {

/// The sign that people read; files, logs and the command line have '-'.
inline constexpr const char* true_minus = "−";

/// `digits` (1..17) significant digits, without trailing zeros, "−" for minus; a whole part is never rounded to fewer
/// digits than it has. "1e−12" style below 1e-4 and from 1e6 (or from 10^digits if that is more).
std::string number_text(double value, int digits = 4);

/// Four digits, or as many more as tell the three apart where they differ.
int digits_that_tell_apart(double a, double b, double c);

/// "(−2)" for "−2", where a sign stands before it.
std::string parenthesized_if_negative(const std::string& number);

/// number_text of what something is "at most", >= 0: rounded up, so that the text is no less than `value` but for its
/// last bits.
std::string bound_text(double value, int digits = 4);

/// "0.5" for "0.500".
std::string without_trailing_zeros(std::string text);

/// Exactly `decimals` digits after the point, "−" for minus, never "−0": for columns.
std::string fixed_text(double value, int decimals);

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
