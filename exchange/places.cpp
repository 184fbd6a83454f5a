#include "exchange/places.h"

#include <algorithm>

#include "core/base/sentence.h"

namespace batten::exchange {

std::string line_place(std::size_t line) {
    return core::sentence("line {line}", {{"line", line}});
}

std::size_t line_of(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, offset);
    return static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1;
}

}  // namespace batten::exchange
