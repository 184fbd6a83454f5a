#include "app/editor/scene/moving_polygon.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "app/editor/scene/canvas_labels.h"
#include "app/editor/scene/control_points.h"
#include "app/editor/scene/control_polygon.h"

namespace batten::editor {

namespace {

constexpr double apart = 24.0;  // corners of one name that are nearer have it once, in design pixels

/// How much is seen of a name that is another one at the end: nothing half way.
double opacity_half_way(double share) {
    return std::min(1.0, 4.0 * std::abs(share - 0.5));
}

/// The corners with the names that they have now.
std::vector<MovingPoint> named_points(const CanvasFrame& frame, const MovingPolygon& moving) {
    std::vector<MovingPoint> points;
    for (const CutCorner& corner : moving.corners)
        points.push_back({frame.screen(corner.place), moving.share < 0.5 ? corner.index : corner.next, corner.weight,
                          corner.index == corner.next ? 1.0 : opacity_half_way(moving.share)});
    for (std::size_t k = frame.curve->is_periodic() ? 0 : 1; k < points.size(); ++k) {
        const MovingPoint& before = points[(k + points.size() - 1) % points.size()];
        const double distance = glm::distance(before.place, points[k].place) / frame.pen.px(apart);
        if (before.index == points[k].index) points[k].opacity *= std::clamp(distance - 1.0, 0.0, 1.0);
    }
    return points;
}

std::vector<glm::dvec2> line_through(const CanvasFrame& frame, const MovingPolygon& moving) {
    std::vector<glm::dvec2> line;
    for (const CutCorner& corner : moving.corners) line.push_back(frame.screen(corner.place));
    if (frame.curve->is_periodic()) line.push_back(line.front());
    return line;
}

/// Leaves only what is of points in full size.
void keep_large(const core::Curve& curve, const ShownPoints& shown, MovingPolygon& moving,
                std::vector<MovingPoint>& points) {
    const std::vector<bool> is_large = is_among(shown.large, curve.control_points().size());
    std::size_t kept = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (!is_large[moving.corners[k].next]) continue;
        moving.corners[kept] = moving.corners[k];
        points[kept++] = points[k];
    }
    moving.corners.resize(kept);
    points.resize(kept);
}

std::vector<MarkPlace> moved_places(const CanvasFrame& frame, const std::vector<MarkPlace>& places,
                                    const MovingPolygon& moving) {
    const std::vector<bool> is_there = is_among(places, frame.curve->control_points().size());
    std::vector<MarkPlace> moved;
    for (const CutCorner& corner : moving.corners)
        if (is_there[corner.next]) moved.push_back({corner.next, frame.screen(corner.place)});
    return moved;
}

}  // namespace

ShownPoints moved_points(const CanvasFrame& frame, const ShownPoints& points, const MovingPolygon& moving) {
    ShownPoints moved = points;
    moved.crowd.shown = moved_places(frame, points.crowd.shown, moving);
    moved.large = moved_places(frame, points.large, moving);
    return moved;
}

void draw_moving_line(CanvasFrame& frame, const MovingPolygon& moving) {
    frame.pen.line(line_through(frame, moving), control_polygon_stroke(frame));
}

void draw_moving_points(CanvasFrame& frame, const render::DrawList& list, MovingPolygon moving) {
    CanvasMarks marks;
    marks.polygon.runs.push_back(line_through(frame, moving));
    const ShownPoints shown = shown_points(frame);
    marks.points = moved_points(frame, shown, moving);
    std::vector<MovingPoint> points = named_points(frame, moving);
    keep_large(*frame.curve, shown, moving, points);
    if (frame.state.view.parts.points)
        for (const CutCorner& corner : moving.corners)
            draw_moving_point(frame, frame.screen(corner.place), corner.next, corner.weight);
    if (frame.shows(Overlay::labels)) draw_moving_labels(frame, list, marks, points);
}

}  // namespace batten::editor
