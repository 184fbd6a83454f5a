/// Formulas of LaTeX in the notation of labels, for painters that know no LaTeX.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace batten::render {

struct FormulaLabel {
    std::string text;                    ///< in the notation of Label
    std::vector<std::string> unknown{};  ///< commands that stand there as they were typed, in order
    bool is_whole = true;                ///< no fraction, root, font or script lacks what it is of
};

/// A formula (what stands between dollar signs, with balanced braces) on one line: "\alpha_i \le \frac{1}{6}" as
/// "α_{i} ≤ ⅙", "\frac{a}{b+1}" as "a/(b + 1)", "\sqrt{2}" as "√2", "\mathbb{R}" as "ℝ". Blanks are set around
/// relations and between what is added, not where they were typed.
FormulaLabel formula_label(std::string_view formula);

}  // namespace batten::render
