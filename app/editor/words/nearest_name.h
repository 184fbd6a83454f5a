/// The name that somebody meant who typed another one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace batten::editor {

/// The one of `names` that `typed` is most like, whatever its case: of its letters at most one in three is wrong,
/// missing, too many or changes places with its neighbor, or `typed` is its beginning, of three letters or more. Of
/// several the first one; none where none is like it. Cost: the sum of the squares of the lengths of `names`, however
/// long `typed` is. Source: the distance of Damerau (1964), as optimal string alignment.
std::optional<std::string> nearest_name(std::string_view typed, std::span<const std::string> names);

}  // namespace batten::editor
