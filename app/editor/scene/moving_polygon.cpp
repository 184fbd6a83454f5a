#include "app/editor/scene/moving_polygon.h"

#include <vector>

#include "app/editor/scene/canvas_labels.h"
#include "app/editor/scene/control_points.h"

namespace batten::editor {

namespace {

/// Whether corner `k` is no half of one that goes.
bool stays(std::span<const CutCorner> corners, std::size_t k) {
    const auto is_other_half = [&](std::size_t other) { return corners[other].index == corners[k].index; };
    return !(k > 0 && is_other_half(k - 1)) && !(k + 1 < corners.size() && is_other_half(k + 1));
}

void draw_polygon(CanvasFrame& frame, std::span<const MovingPoint> points) {
    std::vector<glm::dvec2> line;
    for (const MovingPoint& point : points) line.push_back(point.place);
    if (frame.curve->is_periodic()) line.push_back(line.front());
    frame.pen.line(line, {.color = frame.theme.polygon, .width = 1.5, .dash = 6.0, .gap = 5.0});
}

}  // namespace

void draw_moving_polygon(CanvasFrame& frame, const render::DrawList& list, std::span<const CutCorner> corners,
                         const MovingParts& parts) {
    if (frame.curve == nullptr || corners.empty()) return;
    std::vector<MovingPoint> points;
    for (std::size_t k = 0; k < corners.size(); ++k)
        points.push_back({corners[k].index, frame.screen(corners[k].place), stays(corners, k)});
    if (parts.polygon) draw_polygon(frame, points);
    if (parts.points)
        for (const MovingPoint& point : points) draw_moving_point(frame, point.place, point.index, point.stays);
    if (parts.names) draw_moving_labels(frame, list, points);
}

}  // namespace batten::editor
