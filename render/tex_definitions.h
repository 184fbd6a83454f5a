/// What a stock LaTeX lacks of the commands of a figure, defined for where the paper has no package that does.
#pragma once

#include <string>
#include <string_view>

namespace batten::render {

/// A line for each such command in `tex`, which a package of the paper takes precedence over: "\mathbb" as bold
/// letters, "\text" as a box. Empty where a stock LaTeX has them all.
std::string tex_definitions(std::string_view tex);

}  // namespace batten::render
