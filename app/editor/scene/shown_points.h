/// Which control points are drawn: all, or where they are too many for the picture, some of them.
#pragma once

#include "app/editor/scene/crowd.h"

namespace batten::editor {

/// The control points in the picture.
struct ShownPoints {
    Crowd crowd;                   ///< those that are drawn alike; small ones lie below the curve
    std::vector<MarkPlace> large;  ///< those that are drawn in full size above it: all, or what the user points at
    std::size_t seen = 0;          ///< how many there are in the picture
};

/// None without the polygon's overlay (in a figure, where neither they nor their names are asked for), or of a curve
/// that is made of points to pass. The frame must have a curve.
ShownPoints shown_points(const CanvasFrame& frame);

/// Whether the points are too dense to be drawn in full size.
inline bool is_dense(const ShownPoints& points) {
    return points.crowd.is_small || points.crowd.is_thinned;
}

/// Whether one of the control points drawn in full size is within `distance_px` of `place`. Cost logarithmic.
bool has_point_near(const CanvasFrame& frame, const ShownPoints& points, glm::dvec2 place, double distance_px);

}  // namespace batten::editor
