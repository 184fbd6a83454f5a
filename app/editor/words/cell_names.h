/// How the points of a construction are named, and by what alpha they are made.
#pragma once

#include <string>

#include "app/editor/state/notation.h"
#include "core/evaluate/de_boor_polygons.h"

namespace batten::editor {

/// The triangle of a curve, to be named. Of a closed curve level 0 has the names that the canvas has (i mod n); the
/// other levels keep the numbering of the unrolled points and knots, which their formulas need. The index of a point
/// above level 0 is that of its last or of its first parent, as the notation says.
struct NamedTriangle {
    const core::Curve& curve;
    const core::DeBoorTriangle& triangle;
    const Notation& notation;

    const core::DeBoorCell& cell(core::CellPlace place) const { return triangle.levels[place.level][place.index]; }

    /// "P_{3}^{1}", on level 0 "P_{3}", on the last level "C(u)".
    std::string point(core::CellPlace place) const;

    /// "w_{3}^{1}", on level 0 "w_{3}", on the last level "w(u)".
    std::string weight(core::CellPlace place) const;

    /// "α_{3}^{1}", on level >= 1.
    std::string alpha(core::CellPlace place) const;
};

/// The two lines "α_{3}^{1} = (u − u_{3})/(u_{6} − u_{3})" and "= (2/5 − 0)/(3/4 − 0) = 8/15", for level >= 1. All are
/// decimals where one is no small fraction; knots closer than four digits tell are written with more. Negative numbers
/// that are subtracted stand in parentheses.
struct AlphaFormula {
    std::string symbols;
    std::string numbers;
};
AlphaFormula alpha_formula(const NamedTriangle& named, core::CellPlace place);

}  // namespace batten::editor
