#include "app/editor/scene/bezier_polygons.h"

#include <algorithm>
#include <cmath>

#include "core/evaluate/bezier_pieces.h"

namespace batten::editor {

namespace {

constexpr double merged_spans = 24.0;      // of sixteen spans that are shorter together the first is drawn
constexpr double most_piece_points = 1.0;  // for each pixel of the picture's width
constexpr double piece_margin = 8.0;

void draw_piece(CanvasFrame& frame, const core::BezierPiece& piece) {
    std::vector<core::Point> points;
    core::Box box;
    for (const core::HomogeneousPoint& point : piece.points) {
        points.push_back(core::project(point));
        box.include(points.back());
    }
    if (!box.intersects(frame.seen(frame.pen.px(piece_margin)))) return;
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

Thinned draw_bezier_pieces(CanvasFrame& frame) {
    Thinned pieces;
    std::vector<std::size_t> spans;
    frame.kept->strips().visit_spans(frame.seen(frame.pen.px(piece_margin)),
                                     frame.pen.px(merged_spans) / frame.state.view.camera.scale, most_candidates(frame),
                                     [&](std::size_t span, core::Point, std::size_t count) {
                                         spans.push_back(span);
                                         pieces.seen += count;
                                     });
    const double points = static_cast<double>(spans.size()) * (frame.curve->degree() + 1);
    const double stride = std::ceil(points / std::max(1.0, most_piece_points * frame.pen.size_px().x));
    for (std::size_t k = 0; k < spans.size(); k += static_cast<std::size_t>(std::max(1.0, stride))) {
        draw_piece(frame, core::bezier_piece(*frame.curve, spans[k]));
        ++pieces.shown;
    }
    return pieces;
}

}  // namespace batten::editor
