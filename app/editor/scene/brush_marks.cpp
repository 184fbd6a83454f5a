#include "app/editor/scene/brush_marks.h"

#include <algorithm>

#include "app/editor/pointer/brush.h"
#include "app/editor/scene/curve_strokes.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

constexpr double tinted_radius = 13.0;
constexpr double least_tint = 0.08;  // which still is seen
constexpr double most_tint = 0.6;    // through which the point is seen
constexpr double painted_width = 11.0;
constexpr double painted_tint = 0.45;
constexpr int places_in_span = 48;

void draw_held(CanvasFrame& frame, const Brushing& mode) {
    if (frame.curve == nullptr) return;
    const auto points = frame.curve->control_points();
    for (const HeldPoint& held : mode.held) {
        if (held.index >= points.size()) continue;
        const double tint = least_tint + (most_tint - least_tint) * held.share;
        frame.pen.symbol(
            frame.screen(points[held.index]),
            {.radius = tinted_radius, .fill = render::faded(frame.theme.accent, tint), .outline = no_color});
    }
}

// A part within one span.
void draw_within_span(CanvasFrame& frame, core::Interval part, const Stroke& stroke) {
    if (!(part.lower < part.upper)) return;
    std::vector<core::Point> points;
    for (int k = 0; k <= places_in_span; ++k)
        points.push_back(core::point_at(
            *frame.curve, std::min(part.lower + part.length() * k / places_in_span, part.upper), core::Side::left));
    frame.pen.line(frame.screen(points), stroke);
}

// Whole spans as such, and what is before and behind them.
void draw_painted_part(CanvasFrame& frame, core::Interval part, const Stroke& stroke) {
    if (!(part.lower < part.upper)) return;
    const core::KnotVector& knots = frame.curve->knots();
    const double first = knots[knots.span_at(part.lower, core::Side::right) + 1];
    const double last = knots[knots.span_at(part.upper, core::Side::left)];
    if (last < first) return draw_within_span(frame, part, stroke);
    draw_within_span(frame, {part.lower, first}, stroke);
    if (first < last) draw_part(frame, {first, last}, stroke);
    draw_within_span(frame, {last, part.upper}, stroke);
}

void draw_painted(CanvasFrame& frame, const Brushing& mode) {
    if (!mode.painted || frame.curve == nullptr) return;
    const Stroke stroke{.color = render::faded(frame.theme.accent, painted_tint), .width = painted_width};
    const core::Interval domain = frame.curve->domain();
    const core::Interval part = *mode.painted;
    draw_painted_part(frame, {std::max(part.lower, domain.lower), std::min(part.upper, domain.upper)}, stroke);
    // Beyond the seam.
    if (part.upper > domain.upper)
        draw_painted_part(frame, {domain.lower, std::min(part.upper - domain.length(), part.lower)}, stroke);
}

}  // namespace

void draw_brush(CanvasFrame& frame, const Brushing& mode) {
    draw_held(frame, mode);
    draw_painted(frame, mode);
    const bool moves = frame.state.view.brush.kind == BrushKind::soft_move && mode.press_px.has_value();
    // While it moves points the circle stays around the place from where they are taken.
    const glm::dvec2 center = moves ? frame.screen(mode.center) : mode.position_px;
    frame.pen.symbol(center, {.radius = frame.state.view.brush.radius,
                              .fill = no_color,
                              .outline = frame.theme.accent,
                              .outline_width = 1.5,
                              .dash = moves ? 5.0 : 0.0});
}

}  // namespace batten::editor
