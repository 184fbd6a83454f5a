/// Lines of any length as far as they are seen: polylines, or ink where these would have more places than the picture
/// can hold.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/editor/scene/kept_ink.h"
#include "app/editor/scene/pen.h"
#include "core/evaluate/curve_strips.h"
#include "core/evaluate/polygon_strips.h"
#include "render/coverage_map.h"

namespace batten::editor {

struct CanvasFrame;
class KeptCurve;

/// A line in pixels of the picture, true to a quarter of a pixel. It has runs or ink.
struct SeenLine {
    std::vector<std::vector<glm::dvec2>> runs;
    std::vector<double> starts;                      ///< how far along the line each run begins; none for a curve
    std::shared_ptr<const render::CoverageMap> ink;  ///< null where runs show all
};

/// Widths, in design pixels, of the active curve and of others.
inline constexpr double active_curve_width = 3.0;
inline constexpr double other_curve_width = 2.0;

/// The line of a curve over `range`, which should begin and end at knots, with at most `places_per_px` places for each
/// pixel of the picture's width. Ink gets the width and the dashes of `stroke`.
SeenLine seen_part(const CanvasFrame& frame, core::CurveStrips& strips, core::Interval range, double places_per_px,
                   const Stroke& stroke);

/// The whole line of a curve, or of a control polygon. Ink is kept in `kept`, and is left out under that of the active
/// curve.
SeenLine seen_curve(const CanvasFrame& frame, KeptCurve& kept, const Stroke& stroke);
SeenLine seen_polygon(const CanvasFrame& frame, KeptCurve& kept, const Stroke& stroke);

/// The whole line of a curve as polylines; none where that takes too many places.
std::optional<SeenLine> seen_polylines(const CanvasFrame& frame, core::CurveStrips& strips);

/// Where and how ink for `stroke` is painted.
InkPlace ink_place(const CanvasFrame& frame, const Stroke& stroke);

/// Paints the whole line of a curve into `map`, the way seen_curve does.
void paint_curve(const CanvasFrame& frame, const core::CurveStrips& strips, const InkPlace& place,
                 render::CoverageMap& map);

void draw_line(CanvasFrame& frame, const SeenLine& line, const Stroke& stroke);

}  // namespace batten::editor
