/// What LaTeX calls signs that are no letters of its own, without packages.
#pragma once

#include <optional>
#include <string_view>

namespace batten::render {

/// In formulas: "\le " for "≤"; none where it has no such sign.
std::optional<std::string_view> math_sign(std::string_view sign);

/// In words: "\%" for "%".
std::optional<std::string_view> text_sign(std::string_view sign);

}  // namespace batten::render
