#include "core/base/number_text.h"

#include <array>
#include <charconv>

namespace batten::core {

std::string shortest_text(double value) {
    std::array<char, 32> buffer{};
    auto* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

}  // namespace batten::core
