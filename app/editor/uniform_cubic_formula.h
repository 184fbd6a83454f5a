/// The basis of the uniform cubic and its conditions as formulas, in the label notation of render::Label.
#pragma once

#include <string>

#include "core/evaluate/uniform_cubic_conditions.h"

namespace batten::editor {

/// "−1/6", with the sign that people read.
std::string exact_text(core::Fraction fraction);

/// "b_{1}(t) = (4 − 6 t^{2} + 3 t^{3})/6", j = 0..3.
std::string piece_formula(std::size_t j);

/// A condition and, written likewise, its numbers: "b_{3}′(1) = b_{2}′(0)" and "1/2 = 1/2".
struct ConditionFormula {
    std::string symbols;
    std::string numbers;
};
ConditionFormula condition_formula(const core::UniformCubicCondition& condition);

/// The sum of the four pieces that must be 1, where a segment begins: "b_{0}(0) + ... = 1" and "1/6 + 2/3 + ... = 1".
ConditionFormula sum_formula();

}  // namespace batten::editor
