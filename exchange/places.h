/// Where in the text of a file something stands.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace batten::exchange {

/// "line 12".
std::string line_place(std::size_t line);

/// The line of the byte at `offset` of `text`, counted from 1. Cost O(offset).
std::size_t line_of(std::string_view text, std::size_t offset);

}  // namespace batten::exchange
