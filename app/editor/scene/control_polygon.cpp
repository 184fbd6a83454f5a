#include "app/editor/scene/control_polygon.h"

#include "app/editor/scene/fit_marks.h"
#include "core/evaluate/farin_points.h"
#include "core/measure/bounds.h"

namespace batten::editor {

namespace {

constexpr double hull_opacity = 0.075;
constexpr double lit_hull_opacity = 0.16;

constexpr double passed_opacity = 0.35;  // where the points that the curve passes are edited instead

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

}  // namespace

Stroke control_polygon_stroke(const CanvasFrame& frame) {
    if (shown_fit(frame) != nullptr) return {.color = render::faded(frame.theme.polygon, passed_opacity), .width = 1.0};
    return {.color = frame.theme.polygon, .width = 1.5, .dash = 6.0, .gap = 5.0};
}

SeenLine polygon_line(const CanvasFrame& frame) {
    return seen_polygon(frame, *frame.kept, control_polygon_stroke(frame));
}

void draw_control_polygon(CanvasFrame& frame, const SeenLine& line) {
    draw_line(frame, line, control_polygon_stroke(frame));
    const auto points = frame.curve->control_points();
    const auto leg = hovered_leg(frame.state.hover);
    if (leg && *leg < core::leg_count(*frame.curve))
        frame.pen.segment(frame.screen(points[*leg]), frame.screen(points[(*leg + 1) % points.size()]),
                          {.color = frame.theme.accent, .width = 2.0});
}

void draw_hull(CanvasFrame& frame) {
    const bool is_lit = frame.lit.shows_hull;
    if (!is_lit && !frame.shows(Overlay::hull)) return;
    const std::vector<core::Point> hull = core::convex_hull(is_lit ? lit_points(frame) : active_points(frame));
    frame.pen.fill(frame.screen(hull), render::faded(frame.theme.accent, is_lit ? lit_hull_opacity : hull_opacity));
}

}  // namespace batten::editor
