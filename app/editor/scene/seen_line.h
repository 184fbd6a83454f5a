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

/// A line in pixels of the picture, true to line_tolerance_px. It has runs or ink.
struct SeenLine {
    std::vector<std::vector<glm::dvec2>> runs;
    std::vector<double> starts;                      ///< how far along the line each run begins; none for a curve
    std::shared_ptr<const render::CoverageMap> ink;  ///< null where runs show all
};

/// How near ink is to the lines, in pixels.
inline constexpr double ink_tolerance_px = 0.25;

/// The same of polylines: nearer in a picture that will be enlarged.
double line_tolerance_px(const CanvasFrame& frame);

/// Widths, in design pixels, of the active curve and of others.
inline constexpr double active_curve_width = 3.0;
inline constexpr double other_curve_width = 2.0;

/// The line of a curve over `range`, which should begin and end at knots, with at most `places_per_px` places for each
/// pixel of the picture's width, more in one that will be enlarged. Ink gets the width and the dashes of `stroke`.
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

/// What of a line is painted.
struct InkPart {
    double tolerance = 0.0;  ///< of chords
    core::Box view;
};

/// What paints chords into `map`, leaving out what would not be seen. `screen` tells where a point of the line is, by a
/// similarity of `screen.scale()` pixels to a unit. Holds `map`.
template <class Screen>
core::ChordRequest chord_request(const InkPlace& place, const InkPart& part, const Screen& screen,
                                 render::CoverageMap& map) {
    const double scale = screen.scale();
    const double reach = 0.5 * place.style.width_px + 1.0;
    const auto is_hidden = [&map, screen, scale, reach](const core::Strip& strip) {
        const auto box = render::PixelBox::between(screen(strip.box.lower), screen(strip.box.upper));
        return map.is_full({box.lower_px - reach, box.upper_px + reach}) ||
               map.is_full_about(screen(strip.first), screen(strip.last), strip.deviation * scale + reach);
    };
    const auto take = [&map, screen, style = place.style](core::Point a, core::Point b) {
        map.stroke(screen(a), screen(b), style);
    };
    return {part.tolerance, part.view, is_hidden, take};
}

/// Paints the whole line of a curve into `map`, no farther from it than a tolerance in pixels, > 0.
void paint_curve(const CanvasFrame& frame, const core::CurveStrips& strips, const InkPlace& place, double tolerance_px,
                 render::CoverageMap& map);

void draw_line(CanvasFrame& frame, const SeenLine& line, const Stroke& stroke);

}  // namespace batten::editor
