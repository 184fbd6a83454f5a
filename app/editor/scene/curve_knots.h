/// The knots of the active curve as diamonds on it.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The diamonds of one knot.
struct CurveKnot {
    double value = 0.0;
    int multiplicity = 1;
    int continuity = 0;
    bool is_interior = true;         ///< not an end of the domain of an open curve
    bool is_lit = false;             ///< linked with what is hovered
    bool is_chosen = false;          ///< hovered or selected itself, here or on the strip
    std::vector<glm::dvec2> places;  ///< one for each diamond, across the curve
};

/// What is drawn: knots inside the domain, ends of an unclamped curve, other ends only while they are lit or chosen.
/// Where knots fall on one another only the first is kept, unless lit. The frame must have a curve.
std::vector<CurveKnot> curve_knots(const CanvasFrame& frame);

void draw_curve_knots(CanvasFrame& frame, const std::vector<CurveKnot>& knots);

}  // namespace batten::editor
