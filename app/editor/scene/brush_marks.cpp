#include "app/editor/scene/brush_marks.h"

#include <algorithm>

#include "app/editor/pointer/brush.h"

namespace batten::editor {

namespace {

constexpr double tinted_radius = 8.0;
constexpr double least_tint = 0.08;  // which still is seen

void draw_held(CanvasFrame& frame, const Brushing& mode) {
    if (frame.curve == nullptr) return;
    const auto points = frame.curve->control_points();
    for (const HeldPoint& held : mode.held) {
        if (held.index >= points.size()) continue;
        const double tint = least_tint + (1.0 - least_tint) * held.share;
        frame.pen.symbol(
            frame.screen(points[held.index]),
            {.radius = tinted_radius, .fill = render::faded(frame.theme.accent, tint), .outline = no_color});
    }
}

}  // namespace

void draw_brush(CanvasFrame& frame, const Brushing& mode) {
    draw_held(frame, mode);
    const bool moves = frame.state.view.brush.kind == BrushKind::soft_move && mode.press_px.has_value();
    // While it moves points the circle stays around the place from where they are taken.
    const glm::dvec2 center = moves ? frame.screen(mode.center) : mode.position_px;
    frame.pen.symbol(center, {.radius = frame.state.view.brush.radius,
                              .fill = no_color,
                              .outline = frame.theme.accent,
                              .outline_width = 1.5,
                              .dash = moves ? 5.0 : 0.0});
}

void light_painted(CanvasFrame& frame, const CanvasMode& mode) {
    const auto* brush = std::get_if<Brushing>(&mode);
    if (brush == nullptr || !brush->painted || frame.curve == nullptr) return;
    const core::Interval domain = frame.curve->domain();
    const core::Interval part = *brush->painted;
    const auto light = [&](double lower, double upper) {
        if (lower < upper) frame.lit.parts.push_back({lower, upper});
    };
    light(std::max(part.lower, domain.lower), std::min(part.upper, domain.upper));
    // Beyond the seam.
    if (part.upper > domain.upper)
        light(domain.lower, std::min(part.upper - domain.length(), std::max(part.lower, domain.lower)));
}

}  // namespace batten::editor
