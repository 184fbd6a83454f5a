#include "app/editor/scene/bezier_points_scene.h"

#include <algorithm>
#include <set>

#include "app/editor/derived/bezier_points.h"

namespace batten::editor {

namespace {

constexpr double bezier_margin = 8.0;
constexpr double merged_pieces = 24.0;  // of sixteen spans that are shorter together one is drawn
constexpr std::size_t most_pieces = 20;
constexpr double bezier_name_size = 14.0;

/// The spans in the picture, nearest to that of the parameter first.
std::vector<std::size_t> chosen_spans(CanvasFrame& frame) {
    std::vector<std::size_t> spans;
    frame.kept->strips().visit_spans(
        frame.seen(frame.pen.px(bezier_margin)), frame.pen.px(merged_pieces) / frame.state.view.camera.scale,
        most_candidates(frame), [&](std::size_t span, core::Point, std::size_t) { spans.push_back(span); });
    const std::size_t now = frame.triangle->span;
    const auto distance = [now](std::size_t span) { return span > now ? span - now : now - span; };
    const std::size_t count = std::min(spans.size(), most_pieces);
    std::ranges::partial_sort(spans, spans.begin() + static_cast<std::ptrdiff_t>(count), {}, distance);
    spans.resize(count);
    return spans;
}

/// A piece as it is drawn.
struct ShownPiece {
    NamedPiece named;
    std::vector<glm::dvec2> places;
    bool is_active = false;  ///< that of the parameter
    render::Color color;
};

ShownPiece shown_piece(const CanvasFrame& frame, const KnotFacts& facts, std::size_t span) {
    ShownPiece piece{named_piece(*frame.curve, facts, span), {}, span == frame.triangle->span, {}};
    for (const core::HomogeneousPoint& point : piece.named.piece.points)
        piece.places.push_back(frame.screen(core::project(point)));
    piece.color = piece.named.is_complete ? frame.theme.accent : frame.theme.dim;
    return piece;
}

void draw_points(CanvasFrame& frame, const ShownPiece& piece, std::set<std::size_t>& written) {
    const auto& [named, places, is_active, color] = piece;
    for (std::size_t k = 0; k < places.size(); ++k) {
        frame.pen.symbol(places[k], {.shape = render::MarkerShape::square,
                                     .radius = 4.0,
                                     .fill = named.is_complete ? color : frame.theme.canvas,
                                     .outline = named.is_complete ? frame.theme.canvas : color,
                                     .outline_width = 1.5});
        // Pieces share their ends.
        if (!written.insert(named.numbers[k]).second) continue;
        frame.labels.push_back({.place = places[k],
                                .words = {{bezier_name(named.numbers[k]),
                                           {.color = is_active ? frame.theme.text : color, .size = bezier_name_size}}},
                                .distance = 9.0,
                                .first = LabelSide::lower_left,
                                .crowding = is_active ? Crowding::cover_symbols : Crowding::leave_out});
    }
}

}  // namespace

void draw_bezier_points(CanvasFrame& frame) {
    const auto facts = frame.state.derived.of(frame.curve->knots());
    std::set<std::size_t> written;
    std::vector<ShownPiece> pieces;
    for (const std::size_t span : chosen_spans(frame)) pieces.push_back(shown_piece(frame, *facts, span));
    for (const ShownPiece& piece : pieces)
        frame.pen.line(piece.places, {.color = piece.color, .width = piece.is_active ? 2.25 : 1.5});
    for (const ShownPiece& piece : pieces) draw_points(frame, piece, written);
}

}  // namespace batten::editor
