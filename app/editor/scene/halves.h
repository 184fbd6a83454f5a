/// The two curves into which u splits the active one, each with its control polygon.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The color of the part before u, and of the part after it.
struct HalfColors {
    render::Color before;
    render::Color after;
};
HalfColors half_colors(const Theme& theme);

/// Both parts of the curve, as a band below it, and their polygons, in a color each. Of a polygon with very many legs
/// those near u. A closed curve is opened there into one, which has one color. Where u is an end there is one part. The
/// frame must have a curve.
void draw_halves(CanvasFrame& frame);

/// The control points that splitting would make.
void draw_points_of_halves(CanvasFrame& frame);

}  // namespace batten::editor
