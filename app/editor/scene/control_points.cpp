#include "app/editor/scene/control_points.h"

#include <algorithm>
#include <optional>

#include "app/editor/pointer/weight_ring.h"

namespace batten::editor {

namespace {

constexpr double radius = 6.5;
constexpr double hovered_radius = 8.0;
constexpr double pin_radius = 2.5;

bool is_hovered(const CanvasFrame& frame, std::size_t i) {
    const auto* point = std::get_if<HoveredPoint>(&frame.state.hover);
    const auto* basis = std::get_if<HoveredBasis>(&frame.state.hover);
    const auto* lifted = std::get_if<HoveredLifted>(&frame.state.hover);
    if (lifted != nullptr && lifted->index == i) return true;
    return (point != nullptr && point->index == i) || (basis != nullptr && basis->index == i);
}

bool is_lit(const CanvasFrame& frame, std::size_t i) {
    return std::binary_search(frame.lit.points.begin(), frame.lit.points.end(), i);
}

void draw_first_box(CanvasFrame& frame, glm::dvec2 place) {
    frame.pen.symbol(place, {.shape = render::MarkerShape::square,
                             .radius = 10.0,
                             .fill = no_color,
                             .outline = frame.theme.dim,
                             .outline_width = 1.25});
}

void draw_weight_ring(CanvasFrame& frame, glm::dvec2 place, std::size_t i, std::optional<double> ring_px) {
    if (!ring_px) return;
    const auto* ring = std::get_if<HoveredWeightRing>(&frame.state.hover);
    frame.pen.symbol(place, {.radius = *ring_px / frame.pen.px(1.0),
                             .fill = no_color,
                             .outline = frame.theme.point(frame.hue(i)),
                             .outline_width = ring != nullptr && ring->index == i ? 2.5 : 1.5,
                             .dash = 3.0});
}

void draw_control_point(CanvasFrame& frame, glm::dvec2 place, std::size_t i) {
    const bool is_large = is_hovered(frame, i) || is_lit(frame, i);
    const double size = is_large ? hovered_radius : radius;
    frame.pen.symbol(
        place,
        {.radius = size, .fill = frame.theme.point(frame.hue(i)), .outline = frame.theme.canvas, .outline_width = 2.0});
    if (frame.is_pinned(i))
        frame.pen.symbol(place, {.shape = render::MarkerShape::square,
                                 .radius = pin_radius,
                                 .fill = frame.theme.canvas,
                                 .outline = no_color});
    // Just outside of the disc, so that it stays apart from the smallest weight ring.
    if (frame.state.selection.contains_point(i))
        frame.pen.symbol(place,
                         {.radius = size + 1.0, .fill = no_color, .outline = frame.theme.accent, .outline_width = 2.0});
}

}  // namespace

void draw_dense_points(CanvasFrame& frame, const ShownPoints& points) {
    if (!is_dense(points)) return;
    for (const auto& [i, place] : points.crowd.shown) {
        const bool is_selected = frame.state.selection.contains_point(i);
        frame.pen.symbol(place, {.radius = points.crowd.radius,
                                 .fill = is_selected ? frame.theme.accent : frame.theme.point(frame.hue(i)),
                                 .outline = no_color});
    }
}

void draw_control_points(CanvasFrame& frame, const ShownPoints& points) {
    // Rings are lines: all of them, and then all points, are painted in one go.
    for (const auto& [i, place] : points.large)
        draw_weight_ring(frame, place, i, weight_ring_radius_px(frame.state, i));
    for (const auto& [i, place] : points.large) {
        if (i == 0) draw_first_box(frame, place);
        draw_control_point(frame, place, i);
    }
}

void draw_moving_point(CanvasFrame& frame, glm::dvec2 place, std::size_t i, double weight) {
    draw_weight_ring(frame, place, i, weight_ring_radius_px(weight, frame.state.view.interface_scale));
    if (i == 0) draw_first_box(frame, place);
    draw_control_point(frame, place, i);
}

}  // namespace batten::editor
