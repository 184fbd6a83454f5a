#include "app/editor/scene/construction.h"

#include "app/editor/derived/construction_cells.h"

namespace batten::editor {

namespace {

using Level = std::vector<core::DeBoorCell>;

constexpr double segment_width = 1.75;
constexpr double point_radius = 4.0;

void draw_segments(CanvasFrame& frame, std::size_t r) {
    const Level& from = frame.triangle->levels[r - 1];
    for (std::size_t j = 0; j + 1 < from.size(); ++j)
        frame.pen.segment(frame.screen(from[j].point), frame.screen(from[j + 1].point),
                          {.color = frame.theme.level(r), .width = segment_width});
}

void draw_points(CanvasFrame& frame) {
    for (const auto [level, index] : marked_cells(frame.state.view, *frame.triangle))
        frame.pen.symbol(frame.screen(frame.triangle->levels[level][index].point), {.radius = point_radius,
                                                                                    .fill = frame.theme.level(level),
                                                                                    .outline = frame.theme.canvas,
                                                                                    .outline_width = 1.5});
}

std::size_t shown_level(const CanvasFrame& frame) {
    return editor::shown_level(frame.state.view, frame.curve->degree());
}

/// The hovered cell, here or in a triangle: its point and the segment that it divides.
void draw_hovered_cell(CanvasFrame& frame) {
    const auto cell = hovered_cell(frame.state, *frame.triangle);
    if (!cell) return;
    const auto& levels = frame.triangle->levels;
    const render::Color color = cell->level == 0 ? frame.theme.accent : frame.theme.level(cell->level);
    if (cell->level > 0) {
        const Level& from = levels[cell->level - 1];
        const glm::dvec2 a = frame.screen(from[cell->index].point);
        const glm::dvec2 b = frame.screen(from[cell->index + 1].point);
        frame.pen.segment(a, b, {.color = color, .width = 4.0});
    }
    frame.pen.symbol(frame.screen(levels[cell->level][cell->index].point),
                     {.radius = 9.5, .fill = no_color, .outline = color, .outline_width = 2.0});
}

}  // namespace

void draw_construction(CanvasFrame& frame) {
    const std::size_t last = shown_level(frame);
    for (std::size_t r = 1; r <= last; ++r) draw_segments(frame, r);
    draw_points(frame);
    draw_hovered_cell(frame);
}

void draw_curve_point(CanvasFrame& frame) {
    const bool is_reached =
        !frame.shows(Overlay::construction) || shown_level(frame) + 1 == frame.triangle->levels.size();
    const bool is_hovered = std::holds_alternative<HoveredParameter>(frame.state.hover);
    frame.pen.symbol(frame.screen(frame.triangle->point()),
                     {.radius = is_hovered ? 9.5 : 8.0,
                      .fill = is_reached ? frame.theme.parameter : frame.theme.canvas,
                      .outline = is_reached ? frame.theme.canvas : frame.theme.parameter,
                      .outline_width = 2.0});
}

}  // namespace batten::editor
