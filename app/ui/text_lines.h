/// Texts that are broken into lines where they find room.
#pragma once

#include <string>
#include <vector>

#include "app/ui/fonts.h"

namespace batten::ui {

/// A text in the notation of rich_text, broken between words.
struct TextLines {
    std::vector<std::string> lines;
    float width_px = 0.0F;  ///< of the widest line
    bool is_whole = true;   ///< nothing had to be left out
};

/// At most `most` (> 0) lines of `text` in `font`, each at most `width_px` wide unless a single word is wider; where
/// that is not enough the text ends with a clause and "…", else with a word and "…".
TextLines broken_into_lines(const std::string& text, ImFont* font, float width_px, std::size_t most);

}  // namespace batten::ui
