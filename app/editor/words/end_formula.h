/// The formulas of the derivatives at an end of a curve, with the numbers put in.
#pragma once

#include <string>
#include <vector>

#include "app/editor/state/notation.h"
#include "core/evaluate/end_derivatives.h"

namespace batten::editor {

/// A formula by its letters, and the lines that follow with numbers in the place of letters, the last one its value.
struct EndFormula {
    std::string symbols;
    std::vector<std::string> numbers;
};

/// "C′(0) = p (P_{1} − P_{0})/(u_{4} − u_{3})", "= 3 · ((1, 2) − (0, 0))/(1 − 0)", "= (3, 6)"; with weights
/// "C′(0) = p w_{1}/w_{0} (P_{1} − P_{0})/(u_{4} − u_{3})".
EndFormula first_end_formula(const core::EndDerivatives& at, const Notation& notation);

/// The same of C″, where the degree is 2 at least; with weights "C″(0) = a (P_{2} − P_{0}) − b (P_{1} − P_{0})", and
/// the factors a and b among the lines.
EndFormula second_end_formula(const core::EndDerivatives& at, const Notation& notation);

}  // namespace batten::editor
