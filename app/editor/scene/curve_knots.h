/// The knots of the active curve as diamonds on it.
#pragma once

#include "app/editor/scene/shown_points.h"

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

/// The knots in the picture.
struct ShownKnots {
    std::vector<CurveKnot> knots;
    double radius = 0.0;      ///< of the diamonds, in design pixels; small ones have no fill
    bool is_thinned = false;  ///< there are clearly fewer than in the picture
    std::size_t seen = 0;     ///< how many there are in the picture, drawn or not
};

/// A knot that may be drawn.
struct SeenKnot {
    double value = 0.0;
    core::Point point{};
    std::size_t count = 1;  ///< of knots that are seen as this one
};

/// The knots that are seen, of those that fall together the first, and all that are lit or chosen; ascending. The
/// frame must have a curve.
std::vector<SeenKnot> seen_knots(const CanvasFrame& frame);

/// What is drawn: knots inside the domain, ends of an unclamped curve, other ends only while they are lit or chosen.
/// Where knots fall on one another only the first is kept, unless lit, and no more than the picture can hold. None
/// without their overlay, or of a curve that is made of points, which are shown there. The frame must have a curve.
ShownKnots shown_knots(const CanvasFrame& frame, const ShownPoints& points);

/// How many knots are drawn, multiple ones as often as they occur.
std::size_t knot_count(const ShownKnots& shown);

void draw_curve_knots(CanvasFrame& frame, const ShownKnots& shown);

}  // namespace batten::editor
