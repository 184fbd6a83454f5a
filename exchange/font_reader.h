/// Reads the outlines of letters from font files, as curves.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "exchange/report.h"

namespace batten::exchange {

/// What is to be written with a font, and where.
struct Lettering {
    std::string text;                ///< UTF-8; a line break begins another line
    core::Point position{0.0, 0.0};  ///< of the left end of the first base line
    std::optional<double> size{};    ///< of the em (> 0); none: coordinates are the units of the font, without rounding
};

/// More characters are refused.
inline constexpr std::size_t most_letters = 10'000;

/// Letters that would make more points of outlines are left out.
inline constexpr std::size_t most_letter_points = 4'000'000;

/// The outlines of the letters of `lettering.text` in the font file `font` (TrueType, OpenType, Type 1 and what else
/// FreeType reads; of several faces the first), one closed curve for each contour: piecewise quadratic from TrueType,
/// cubic from PostScript outlines, exactly those of the font, without hints. Each letter follows the one before by its
/// advance and the pair's kerning (the table `kern`); letters are not joined to ligatures, nor turned to the left. A
/// curve is called by its letter, a second contour "A 2", and the contours of a letter are a group.
/// Errors: no font; only of pixels; no Unicode; text that is no UTF-8 or too long; nothing to draw. Characters that the
/// font does not have, and those from which on the outlines had more than `most_points` points, are left out and told.
/// Cost O(size of the font + outlines).
[[nodiscard]] core::FileResult<Imported> read_glyphs(std::string_view font, const Lettering& lettering,
                                                     std::size_t most_points = most_letter_points);

}  // namespace batten::exchange
