/// Numbers as people type them: "1/3", "sqrt(2)/2", "30 deg", "0,5".
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "core/document/units.h"

namespace batten::editor {

/// The place of the first of `separators` that stands in no parentheses; npos without one.
std::size_t find_outside_parentheses(std::string_view text, std::string_view separators);

/// What a number without a unit stands for.
enum class ExpressionUnit {
    number,  ///< for itself; an angle is the number of its radians
    degrees
};

/// The value of `text`: decimal numbers ("2", ".5", "1e-3", "0,5" with a decimal comma), + - * / ^ and parentheses with
/// their usual precedence, pi, the functions sqrt, sin, cos, tan, asin, acos, atan, exp, ln and abs, and after a
/// product deg, ° or rad; with `lengths` also mm, in (or inch) and px, for so much of the world as they are there.
/// Spaces are free, the typographic minus is a minus, and letters may be capitals. The same whatever the system's
/// language. The error is one sentence: what was found and what is allowed, or that the result is not a finite number.
[[nodiscard]] tl::expected<double, std::string> parse_expression(std::string_view text,
                                                                 ExpressionUnit unit = ExpressionUnit::number,
                                                                 const core::DocumentUnits* lengths = nullptr);

/// What is typed over a value that is there: "+=2", "-=2", "*=2", "/=2" and "^=2" change `present`, an expression or
/// empty for none; anything else stands for itself.
std::string typed_over(std::string_view typed, std::string_view present);

/// The values of a list, separated by commas or semicolons, or by spaces when it has neither; what stands in
/// parentheses is one value, brackets around the list are allowed, and so is a comma at its end. Decimals need a point.
/// The error names the entry, counted from 0.
[[nodiscard]] tl::expected<std::vector<double>, std::string> parse_expressions(
    std::string_view text, const core::DocumentUnits* lengths = nullptr);

}  // namespace batten::editor
