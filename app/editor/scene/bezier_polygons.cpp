#include "app/editor/scene/bezier_polygons.h"

#include <algorithm>
#include <cmath>

#include "core/evaluate/bezier_pieces.h"

namespace batten::editor {

namespace {

constexpr double merged_polygon_spans = 24.0;  // of sixteen spans that are shorter together the first is drawn
constexpr double most_piece_points = 1.0;      // for each pixel of the picture's width
constexpr double piece_margin = 8.0;

/// The places of a piece's points; none where it is not seen.
std::vector<glm::dvec2> seen_places(const CanvasFrame& frame, const core::BezierPiece& piece) {
    std::vector<core::Point> points;
    core::Box box;
    for (const core::HomogeneousPoint& point : piece.points) {
        points.push_back(core::project(point));
        box.include(points.back());
    }
    if (!box.intersects(frame.seen(frame.pen.px(piece_margin)))) return {};
    return frame.screen(points);
}

/// All lines first, which are then painted in one go, as are the points.
void draw_polygons(CanvasFrame& frame, const std::vector<std::vector<glm::dvec2>>& polygons) {
    for (const auto& places : polygons) frame.pen.line(places, {.color = frame.theme.dim, .width = 1.25});
    for (const auto& places : polygons)
        for (const glm::dvec2 place : places)
            frame.pen.symbol(place, {.shape = render::MarkerShape::square,
                                     .radius = 2.75,
                                     .fill = frame.theme.dim,
                                     .outline = frame.theme.canvas,
                                     .outline_width = 1.0});
}

}  // namespace

Thinned draw_bezier_pieces(CanvasFrame& frame) {
    Thinned pieces;
    std::vector<std::size_t> spans;
    frame.kept->strips().visit_spans(frame.seen(frame.pen.px(piece_margin)),
                                     frame.pen.px(merged_polygon_spans) / frame.state.view.camera.scale,
                                     most_candidates(frame), [&](std::size_t span, core::Point, std::size_t count) {
                                         spans.push_back(span);
                                         pieces.seen += count;
                                     });
    const double points = static_cast<double>(spans.size()) * (frame.curve->degree() + 1);
    const double stride = std::ceil(points / std::max(1.0, most_piece_points * frame.pen.size_px().x));
    std::vector<std::vector<glm::dvec2>> polygons;
    for (std::size_t k = 0; k < spans.size(); k += static_cast<std::size_t>(std::max(1.0, stride))) {
        polygons.push_back(seen_places(frame, core::bezier_piece(*frame.curve, spans[k])));
        ++pieces.shown;
    }
    draw_polygons(frame, polygons);
    return pieces;
}

}  // namespace batten::editor
