/// The lines of the lecture that say how a point of the construction is made of the two before it.
#pragma once

#include <string>

#include "app/editor/words/cell_names.h"

namespace batten::editor {

/// Two numbers whose sum is 1, alike: as exact_texts has them, "7/15" and "8/15" or "0.65" and "0.35", where both are
/// small fractions, else as "0.467" and "0.533".
struct ShareTexts {
    std::string lower;
    std::string upper;
};

/// Of 1 - `upper` and `upper`, from 0 to 1.
ShareTexts share_texts(const Notation& notation, double upper);

/// A cell of level >= 1 and what it is made of.
struct BlendedCell {
    NamedTriangle named;
    core::CellPlace place;

    core::CellPlace lower() const { return {place.level - 1, place.index}; }
    core::CellPlace upper() const { return {place.level - 1, place.index + 1}; }
    double alpha() const { return named.cell(place).alpha; }

    /// The share of the upper parent in the Euclidean point, α w_upper / w; that of the lower one makes 1 with it.
    /// Alpha itself where the weights are equal.
    double euclidean_share() const;
};

/// "7/15 P_{2}" and "8/15 P_{3}", of a rational curve "7/15 w_{2} P_{2}": what alpha makes of the parents.
ShareTexts blend_terms(const BlendedCell& blended);

/// "P_{3}^{1} = 7/15 P_{2} + 8/15 P_{3}", by the Euclidean shares; "P_{4}^{1} = P_{3}" where all of it is one of them.
std::string blend_line(const BlendedCell& blended);

/// "w_{3}^{1} P_{3}^{1} = 7/15 w_{2} P_{2} + 8/15 w_{3} P_{3}": the same in homogeneous coordinates, where the shares
/// are 1 - alpha and alpha.
std::string homogeneous_line(const BlendedCell& blended);

/// The third coordinate of that: "w_{3}^{1} = 7/15 w_{2} + 8/15 w_{3}" and "= 7/15 · 1 + 8/15 · 2 = 23/15".
struct WeightFormula {
    std::string symbols;
    std::string numbers;
};
WeightFormula weight_formula(const BlendedCell& blended);

/// "P_{3}^{1} = (7/15 w_{2} P_{2} + 8/15 w_{3} P_{3}) / w_{3}^{1}", which blend_line works out.
std::string projected_line(const BlendedCell& blended);

}  // namespace batten::editor
