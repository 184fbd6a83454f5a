/// The polygons that stand in the triangle of de Boor: what inserting u makes of the control polygon of the span, and
/// the two polygons into which u splits it.
#pragma once

#include <vector>

#include "core/evaluate/de_boor.h"

namespace batten::core {

/// The cell levels[level][index] of a triangle.
struct CellPlace {
    std::size_t level = 0;
    std::size_t index = 0;

    bool operator==(const CellPlace&) const = default;
};

/// The cell of the lowest level that is the same point: where all of a cell is one parent (alpha 0 or 1, because u is a
/// knot), it is that of the parent.
CellPlace origin_of(const DeBoorTriangle& triangle, CellPlace place);

/// How often u can be inserted before C(u) is a control point: p less the multiplicity that u has already.
std::size_t insertion_count(const DeBoorTriangle& triangle);

/// The control polygon over the points of the span after u was inserted `times` (at most insertion_count) times, from
/// P_{span-p} to P_span: `times` points more than before. Its new points are those of level `times`; its ends are the
/// sides of the triangle as far as that level. Cells are origins, so none stands twice. Source: Boehm 1980.
std::vector<CellPlace> inserted_polygon(const DeBoorTriangle& triangle, std::size_t times);

/// What inserting u once more, for the `times`-th time (1 to insertion_count), puts into the polygon and takes out of
/// it, each in order.
struct InsertionStep {
    std::vector<CellPlace> added;    ///< the points of level `times`; in the end C(u)
    std::vector<CellPlace> removed;  ///< one less
};
InsertionStep insertion_step(const DeBoorTriangle& triangle, std::size_t times);

/// The control points of the part before u from P_{span-p} to C(u), and of the part after it from C(u) to P_span. Cells
/// are origins. One of them is a point alone where u is an end of the domain to which the curve is clamped. At a tear,
/// where u has the multiplicity p+1, the part before it ends in P_{span-p-1}, which is no point of the span: there are
/// no cells before u.
struct SplitPolygons {
    std::vector<CellPlace> before;
    std::vector<CellPlace> after;
};
SplitPolygons split_polygons(const Curve& curve, const DeBoorTriangle& triangle);

/// Whether the curve is torn at the parameter of the triangle, which is then that of the part after it.
bool is_at_tear(const Curve& curve, const DeBoorTriangle& triangle);

}  // namespace batten::core
