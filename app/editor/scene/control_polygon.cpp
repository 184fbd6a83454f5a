#include "app/editor/scene/control_polygon.h"

#include "core/evaluate/bezier_pieces.h"
#include "core/measure/bounds.h"

namespace batten::editor {

namespace {

constexpr double hull_opacity = 0.075;
constexpr double lit_hull_opacity = 0.16;

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

std::vector<glm::dvec2> polygon_places(const CanvasFrame& frame) {
    std::vector<glm::dvec2> places = frame.screen(frame.curve->control_points());
    if (frame.curve->is_periodic()) places.push_back(places.front());
    return places;
}

void draw_control_polygon(CanvasFrame& frame) {
    const std::vector<glm::dvec2> places = polygon_places(frame);
    frame.pen.line(places, {.color = frame.theme.polygon, .width = 1.5, .dash = 6.0, .gap = 5.0});
    const auto* leg = std::get_if<HoveredLeg>(&frame.state.hover);
    if (leg != nullptr && leg->index + 1 < places.size())
        frame.pen.segment(places[leg->index], places[leg->index + 1], {.color = frame.theme.accent, .width = 2.0});
}

void draw_hull(CanvasFrame& frame) {
    const bool is_lit = frame.lit.shows_hull;
    if (!is_lit && !frame.shows(Overlay::hull)) return;
    const std::vector<core::Point> hull = core::convex_hull(is_lit ? lit_points(frame) : active_points(frame));
    frame.pen.fill(frame.screen(hull), render::faded(frame.theme.accent, is_lit ? lit_hull_opacity : hull_opacity));
}

void draw_bezier_polygons(CanvasFrame& frame) {
    for (const core::BezierPiece& piece : core::bezier_pieces(*frame.curve)) draw_bezier_polygon(frame, piece);
}

}  // namespace batten::editor
