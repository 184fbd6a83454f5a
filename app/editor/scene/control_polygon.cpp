#include "app/editor/scene/control_polygon.h"

#include <algorithm>
#include <cmath>

#include "core/evaluate/bezier_pieces.h"
#include "core/measure/bounds.h"

namespace batten::editor {

namespace {

constexpr double hull_opacity = 0.075;
constexpr double lit_hull_opacity = 0.16;
constexpr double merged_pieces = 24.0;      // of sixteen spans that are shorter together the first is drawn
constexpr double most_bezier_points = 1.0;  // for each pixel of the picture's width

Stroke stroke_of(const CanvasFrame& frame) {
    return {.color = frame.theme.polygon, .width = 1.5, .dash = 6.0, .gap = 5.0};
}

std::vector<core::Point> lit_points(const CanvasFrame& frame) {
    std::vector<core::Point> points;
    const auto control = frame.curve->control_points();
    for (const std::size_t i : frame.lit.points) points.push_back(control[i]);
    return points;
}

std::vector<core::Point> active_points(const CanvasFrame& frame) {
    std::vector<core::Point> points;
    for (const core::DeBoorCell& cell : frame.triangle->levels.front()) points.push_back(cell.point);
    return points;
}

void draw_bezier_polygon(CanvasFrame& frame, const core::BezierPiece& piece) {
    std::vector<core::Point> points;
    core::Box box;
    for (const core::HomogeneousPoint& point : piece.points) {
        points.push_back(core::project(point));
        box.include(points.back());
    }
    if (!box.intersects(frame.seen(frame.pen.px(8.0)))) return;
    const std::vector<glm::dvec2> places = frame.screen(points);
    frame.pen.line(places, {.color = frame.theme.dim, .width = 1.25});
    for (const glm::dvec2 place : places)
        frame.pen.symbol(place, {.shape = render::MarkerShape::square,
                                 .radius = 2.75,
                                 .fill = frame.theme.dim,
                                 .outline = frame.theme.canvas,
                                 .outline_width = 1.0});
}

}  // namespace

SeenLine polygon_line(const CanvasFrame& frame) {
    return seen_polygon(frame, *frame.kept, stroke_of(frame));
}

void draw_control_polygon(CanvasFrame& frame, const SeenLine& line) {
    draw_line(frame, line, stroke_of(frame));
    const auto points = frame.curve->control_points();
    const auto* leg = std::get_if<HoveredLeg>(&frame.state.hover);
    const std::size_t leg_count = points.size() - (frame.curve->is_periodic() ? 0U : 1U);
    if (leg != nullptr && leg->index < leg_count)
        frame.pen.segment(frame.screen(points[leg->index]), frame.screen(points[(leg->index + 1) % points.size()]),
                          {.color = frame.theme.accent, .width = 2.0});
}

void draw_hull(CanvasFrame& frame) {
    const bool is_lit = frame.lit.shows_hull;
    if (!is_lit && !frame.shows(Overlay::hull)) return;
    const std::vector<core::Point> hull = core::convex_hull(is_lit ? lit_points(frame) : active_points(frame));
    frame.pen.fill(frame.screen(hull), render::faded(frame.theme.accent, is_lit ? lit_hull_opacity : hull_opacity));
}

void draw_bezier_polygons(CanvasFrame& frame) {
    std::vector<std::size_t> spans;
    frame.kept->strips().visit_spans(
        frame.seen(frame.pen.px(8.0)), frame.pen.px(merged_pieces) / frame.state.view.camera.scale,
        most_candidates(frame), [&](std::size_t span, core::Point, std::size_t) { spans.push_back(span); });
    const double points = static_cast<double>(spans.size()) * (frame.curve->degree() + 1);
    const double stride = std::ceil(points / std::max(1.0, most_bezier_points * frame.pen.size_px().x));
    for (std::size_t k = 0; k < spans.size(); k += static_cast<std::size_t>(std::max(1.0, stride)))
        draw_bezier_polygon(frame, core::bezier_piece(*frame.curve, spans[k]));
}

}  // namespace batten::editor
