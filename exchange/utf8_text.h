/// Names as they stand in files of any encoding, made fit for a document.
#pragma once

#include <string>
#include <string_view>

namespace batten::exchange {

/// `bytes` as UTF-8: as they are where they are such, else each byte taken as a character of Latin-1. Control
/// characters become blanks, and what is longer than 255 bytes loses its end. Cost O(n) for the bytes that are kept.
std::string utf8_text(std::string_view bytes);

/// Appends a character by its number; the replacement character where there is none of that number.
void append_utf8(std::string& text, unsigned long character);

}  // namespace batten::exchange
