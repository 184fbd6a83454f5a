/// Union, intersection and difference of what closed curves enclose.
#pragma once

#include "core/base/progress.h"
#include "core/shape/winding.h"

namespace batten::core {

/// What of two shapes is kept.
enum class ShapeOperation {
    unite,      ///< what is in one of them
    intersect,  ///< what is in both
    subtract,   ///< what is in the first and not in the second
    exclude     ///< what is in one of them and not in the other
};

/// What curves enclose together. They may cross themselves and each other.
struct Shape {
    std::vector<Curve> curves{};
    InsideRule rule = InsideRule::non_zero;
};

/// The boundary of what `operation` keeps of two shapes: closed curves that neither cross themselves nor each other,
/// with the inside on their left, so that holes run clockwise. None where nothing is kept.
///
/// All curves are cut where they meet; an edge is kept where what lies on one side of it is inside and what lies on the
/// other is not, as winding numbers tell. So the curves consist of parts of the old ones, with their control points; a
/// curve that is kept whole is the old one, or that reversed. Parts meet within 1e-12 of the size of everything, and
/// degrees are raised to the highest of a curve. Where curves coincide, the part of the first one is taken. Errors:
/// curve_not_closed, with the curve's index, those of the second shape counted on; shapes_not_decided where curves run
/// along each other too closely to be told apart. Cost: that of intersect_curves for all pairs, and O(n log n).
[[nodiscard]] Result<std::vector<Curve>> combine(const Shape& first, const Shape& second, ShapeOperation operation,
                                                 const Progress& progress = {});

}  // namespace batten::core
