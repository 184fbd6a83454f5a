/// Texts of labels as LaTeX: letters and numbers as formulas, words as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace batten::render {

/// A text in the notation of Label: "P_{3}" as $P_{3}$, "1/6" as $\frac{1}{6}$, "level 2" as it is, signs that LaTeX
/// reads otherwise as themselves. Letters beyond the Latin and Greek ones stand in \battenletters{...}, since a stock
/// LaTeX has no font for them.
std::string tex_text(std::string_view label);

/// What a user wrote: words as they are, and as formulas only what stands between dollar signs.
std::string tex_prose(std::string_view prose);

/// The letters of a label or of prose that stand in \battenletters, in order.
std::vector<std::string> letters_without_tex(std::string_view label);

}  // namespace batten::render
