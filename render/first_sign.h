/// Texts in UTF-8, sign by sign.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace batten::render {

/// The first character, with all its bytes; nothing of an empty text.
inline std::string_view first_sign(std::string_view text) {
    constexpr unsigned going_on = 0x80;
    constexpr unsigned kind = 0xC0;
    std::size_t size = std::min<std::size_t>(1, text.size());
    while (size < text.size() && (static_cast<unsigned char>(text[size]) & kind) == going_on) ++size;
    return text.substr(0, size);
}

}  // namespace batten::render
