#include "app/editor/scene/moving_polygon.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "app/editor/scene/canvas_labels.h"
#include "app/editor/scene/control_points.h"

namespace batten::editor {

namespace {

constexpr double apart = 24.0;  // corners of one name that are nearer have it once, in design pixels

/// How much is seen of a name that is another one at the end: nothing half way.
double opacity_half_way(double share) {
    return std::min(1.0, 4.0 * std::abs(share - 0.5));
}

/// Without the other part of those that are one at the beginning or at the end.
std::vector<CutCorner> corners_apart(std::vector<CutCorner> corners, bool is_periodic) {
    const auto are_one = [](const CutCorner& a, const CutCorner& b) {
        return a.place == b.place && (a.index == b.index || a.next == b.next);
    };
    corners.erase(std::unique(corners.begin(), corners.end(), are_one), corners.end());
    if (is_periodic && corners.size() > 1 && are_one(corners.back(), corners.front())) corners.pop_back();
    return corners;
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

void draw_polygon(CanvasFrame& frame, const std::vector<MovingPoint>& points) {
    std::vector<glm::dvec2> line;
    for (const MovingPoint& point : points) line.push_back(point.place);
    if (frame.curve->is_periodic()) line.push_back(line.front());
    frame.pen.line(line, {.color = frame.theme.polygon, .width = 1.5, .dash = 6.0, .gap = 5.0});
}

}  // namespace

void draw_moving_polygon(CanvasFrame& frame, const render::DrawList& list, MovingPolygon moving,
                         const MovingParts& parts) {
    if (frame.curve == nullptr || moving.corners.empty()) return;
    moving.corners = corners_apart(std::move(moving.corners), frame.curve->is_periodic());
    const std::vector<MovingPoint> points = named_points(frame, moving);
    if (parts.polygon) draw_polygon(frame, points);
    if (parts.points)
        for (const CutCorner& corner : moving.corners)
            draw_moving_point(frame, frame.screen(corner.place), corner.next, corner.weight);
    if (parts.names) draw_moving_labels(frame, list, points);
}

}  // namespace batten::editor
