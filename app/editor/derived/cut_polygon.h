/// The control polygon on the way of a knot that is inserted: its corners are cut off little by little.
#pragma once

#include <vector>

#include "core/refine/corner_cutting.h"

namespace batten::editor {

/// A corner of that polygon.
struct CutCorner {
    core::Point place;
    std::size_t index = 0;  ///< of the control point before the insertion that it comes of
    std::size_t next = 0;   ///< of the control point after the insertion that it goes to
    double weight = 1.0;    ///< on the way from the one's to the other's
};

/// Such a polygon, and how much of its way is done: 0..1.
struct MovingPolygon {
    std::vector<CutCorner> corners{};  ///< none where nothing moves
    double share = 0.0;
};

/// The corners of the polygon of `curve` when `share` (0..1) of `cutting`, an insertion into it, is done: each one that
/// goes is two, on their ways to the new points on its legs. At 0 this is the polygon before, at 1 the one after it,
/// with corners that meet.
std::vector<CutCorner> cut_polygon(const core::Curve& curve, const core::CornerCutting& cutting, double share);

/// The corners without the other part of those that are one at the beginning or at the end, which the last and the
/// first one of a closed polygon may be, too.
std::vector<CutCorner> corners_apart(std::vector<CutCorner> corners, bool is_closed);

}  // namespace batten::editor
