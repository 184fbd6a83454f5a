/// Texts as they are read: sentences hold their numbers in full, so that nothing is lost where they are printed, copied
/// or pointed at; what is on screen has fewer digits.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace batten::editor {

/// `text` with each number at no more than six significant digits, and a true minus sign. A number after "at most" is
/// rounded up. Whole numbers keep their digits, and what stands in quotes or is part of a name stays as it is.
std::string reading_text(const std::string& text);

/// The same with three digits, and without what follows a semicolon and bounds a distance: for who reads from the last
/// row.
std::string brief_reading_text(const std::string& text);

/// The same with all digits, for who wants to know exactly.
std::string full_reading_text(const std::string& text);

/// Where the text in quotes ends that begins at `i` (< size) of `text`: behind its closing quote; `i` where none
/// begins.
std::size_t end_of_quote(std::string_view text, std::size_t i);

}  // namespace batten::editor
