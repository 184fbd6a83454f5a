/// The names beside control points, knots and C(u).
#pragma once

#include "app/editor/scene/control_polygon.h"
#include "app/editor/scene/curve_knots.h"

namespace batten::editor {

/// What labels stand beside, and keep off.
struct CanvasMarks {
    ShownPoints points;
    ShownKnots knots;
    SeenLine polygon;
    Thinned pieces;      ///< with Bézier polygons
    Thinned comb_spans;  ///< with teeth of the comb
    Thinned hulls;       ///< of spans
};

/// "P_{2} · w 2" beside control points, "×2 C^{1}" beside multiple knots, "C(0.400)" beside the point at the parameter,
/// and what views ask for, even without the overlay of labels; all are kept apart from one another, from points,
/// polygon, curve and `covered` boxes. The frame must have a curve.
void draw_canvas_labels(CanvasFrame& frame, const CanvasMarks& marks, const std::vector<render::PixelBox>& covered);

/// A control point on its way somewhere.
struct MovingPoint {
    glm::dvec2 place{};
    std::size_t index = 0;  ///< that it is called by
    double weight = 1.0;
    double opacity = 1.0;  ///< of its name; 0 for none
};

/// The same names beside moving `points`: apart from one another, from `marks` on their way, the curve, and the labels
/// that `list` has.
void draw_moving_labels(CanvasFrame& frame, const render::DrawList& list, const CanvasMarks& marks,
                        std::span<const MovingPoint> points);

}  // namespace batten::editor
