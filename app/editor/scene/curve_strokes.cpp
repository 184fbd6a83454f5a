#include "app/editor/scene/curve_strokes.h"

#include <algorithm>
#include <cmath>

#include "app/editor/scene/directions.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

constexpr double span_width = 4.0;
constexpr double places_of_part = 0.25;  // for each pixel of the picture's width
constexpr double glow_width = 11.0;
constexpr double ghost_share = 0.35;
constexpr double other_share = 0.55;
constexpr double locked_share = 0.35;
constexpr double locked_active_share = 0.7;

void draw_curve(CanvasFrame& frame, KeptCurve& kept, const Stroke& stroke) {
    draw_line(frame, seen_curve(frame, kept, stroke), stroke);
}

/// What lights up belongs to one point, and has its color, or to a knot or span.
render::Color glow_color(const CanvasFrame& frame) {
    render::Color color = frame.theme.accent;
    if (const auto* point = std::get_if<HoveredPoint>(&frame.state.hover))
        color = frame.theme.point(frame.hue(point->index));
    if (const auto* ring = std::get_if<HoveredWeightRing>(&frame.state.hover))
        color = frame.theme.point(frame.hue(ring->index));
    if (const auto* basis = std::get_if<HoveredBasis>(&frame.state.hover))
        color = frame.theme.point(frame.hue(basis->index));
    return render::blended(color, 0.35, frame.theme.canvas);
}

/// A chevron in the middle of the last span; nothing where the curve stands still.
void draw_direction(CanvasFrame& frame, render::Color color) {
    const core::KnotVector& knots = frame.curve->knots();
    const std::size_t s = knots.span_at(frame.curve->domain().upper, core::Side::left);
    const double u = knots[s] + 0.5 * (knots[s + 1] - knots[s]);
    const core::Jet at = core::derivatives_at(*frame.curve, u, 1);
    const double speed = core::length(at[1]);
    if (!(speed > 0.0) || !std::isfinite(speed)) return;
    const glm::dvec2 along = glm::dvec2(at[1].x, -at[1].y) / speed;
    draw_chevron(frame, frame.screen(at.point) + frame.pen.px(4.0) * along, along, color);
}

}  // namespace

render::Color color_of(const core::DocumentCurve& item, const Theme& theme) {
    if (!item.color) return theme.curve;
    return seen_on_canvas({item.color->red, item.color->green, item.color->blue, 255}, theme);
}

render::Color color_of_other(const core::DocumentCurve& item, const Theme& theme) {
    return render::blended(color_of(item, theme), item.locked ? locked_share : other_share, theme.canvas);
}

void draw_part(CanvasFrame& frame, core::Interval range, const Stroke& stroke) {
    draw_line(frame, seen_part(frame, frame.kept->strips(), range, places_of_part, stroke), stroke);
}

void draw_ghost(CanvasFrame& frame) {
    if (!frame.state.ghost) return;
    const render::Color color = render::blended(frame.theme.curve, ghost_share, frame.theme.canvas);
    draw_curve(frame, frame.cache.ghost(frame.state.ghost->curve), {.color = color, .width = other_curve_width});
}

void draw_lit_parts(CanvasFrame& frame) {
    const Stroke glow{.color = glow_color(frame), .width = glow_width};
    for (const core::Interval& part : frame.lit.parts) draw_part(frame, part, glow);
}

void draw_active_curve(CanvasFrame& frame) {
    const core::DocumentCurve& active = *frame.state.shown().active_curve();
    const render::Color full = color_of(active, frame.theme);
    const render::Color color = active.locked ? render::blended(full, locked_active_share, frame.theme.canvas) : full;
    draw_line(frame, frame.curve_line, {.color = color, .width = active_curve_width});
    // One arrow where there are no others.
    if (frame.state.view.parts.arrow && !frame.shows(Overlay::directions)) draw_direction(frame, color);
    if (frame.state.view.parts.parameter)
        draw_part(frame, active_span(frame), {.color = frame.theme.accent, .width = span_width});
}

Symbol hovered_place_symbol(const Theme& theme) {
    return {.radius = 4.0, .fill = theme.canvas, .outline = theme.accent, .outline_width = 2.0};
}

void draw_hovered_place(CanvasFrame& frame) {
    const auto u = hovered_u(frame.state.hover);
    if (!u) return;
    Symbol symbol = hovered_place_symbol(frame.theme);
    if (frame.state.tool == Tool::insert_knot && std::holds_alternative<HoveredCurve>(frame.state.hover)) {
        symbol.shape = render::MarkerShape::diamond;
        symbol.radius = 6.0;
    }
    frame.pen.symbol(frame.screen(core::point_at(*frame.curve, *u)), symbol);
}

}  // namespace batten::editor
