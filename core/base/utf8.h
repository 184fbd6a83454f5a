/// Characters of UTF-8 texts.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace batten::core {

/// How many bytes the character at the front of `text` has, 1 to 4; 0 where there is none. Overlong forms and halves of
/// pairs are none.
std::size_t utf8_length(std::string_view text);

/// The number of that character in Unicode; none where there is none.
std::optional<char32_t> utf8_code(std::string_view text);

/// Whether `byte`, of a text of such characters, is not the first one of its character.
constexpr bool continues_utf8(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U;
}

/// Whether `text` consists of such characters. Cost O(n).
bool is_utf8(std::string_view text);

/// The characters at the front of `text`, which consists of such, that have no more than `most_bytes` together.
std::string_view utf8_front(std::string_view text, std::size_t most_bytes);

}  // namespace batten::core
