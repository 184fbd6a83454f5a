/// The basis of the uniform cubic and its conditions as formulas, in the label notation of render::Label.
#pragma once

#include <string>

#include "app/editor/state/notation.h"
#include "core/base/geometry.h"
#include "core/evaluate/uniform_cubic_conditions.h"

namespace batten::editor {

/// The parameter that runs from 0 to 1 in each segment: "t", or "s" where t is that of the whole curve.
const char* local_parameter(const Notation& notation);

/// "1/6"; with three decimals from 1000 on, where a fraction tells little.
std::string exact_coordinate(const Notation& notation, double value);

/// "(1/6, −2)", of such coordinates.
std::string exact_place(const Notation& notation, core::Point place);
std::string exact_place(const Notation& notation, core::Vector vector);

/// "b_{1}(t) = (4 − 6 t^{2} + 3 t^{3})/6", j = 0..3.
std::string piece_formula(const Notation& notation, std::size_t j);

/// A condition and, written likewise, its numbers: "b_{3}′(1) = b_{2}′(0)" and "1/2 = 1/2".
struct ConditionFormula {
    std::string symbols;
    std::string numbers;
};
ConditionFormula condition_formula(const Notation& notation, const core::UniformCubicCondition& condition);

/// The sum of the four pieces that must be 1, where a segment begins: "b_{0}(0) + ... = 1" and "1/6 + 2/3 + ... = 1".
ConditionFormula sum_formula(const Notation& notation);

}  // namespace batten::editor
