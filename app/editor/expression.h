/// Numbers as people type them: "1/3", "2*(3+1)", "-0.5".
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace batten::editor {

/// The value of `text`: decimal numbers ("2", ".5", "1e-3"), + - * / and parentheses with their usual precedence;
/// spaces are free and the typographic minus is a minus. Always with a decimal point, whatever the system's language.
/// The error is one sentence: what was found and where, or that the result is not a finite number.
[[nodiscard]] tl::expected<double, std::string> parse_expression(std::string_view text);

/// The values of a list, separated by commas or semicolons, or by spaces when it has neither; brackets around it are
/// allowed. The error names the entry, counted from 0.
[[nodiscard]] tl::expected<std::vector<double>, std::string> parse_expressions(std::string_view text);

}  // namespace batten::editor
