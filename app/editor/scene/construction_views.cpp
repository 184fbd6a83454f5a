#include "app/editor/scene/construction_views.h"

#include <algorithm>

#include "app/editor/derived/construction_cells.h"
#include "app/editor/words/blossom_text.h"
#include "app/editor/words/cell_names.h"

namespace batten::editor {

namespace {

constexpr double inserted_width = 5.0;
constexpr double inserted_share = 0.5;  // of the level's color, in the canvas
constexpr double construction_name_size = 13.0;
constexpr double blossom_size = 13.0;
constexpr double cell_label_distance = 10.0;
constexpr std::size_t most_named_cells = 21;  // of the construction's points; of more only the hovered one has its
constexpr std::size_t most_blossoms = 40;     // of control points; of more those of the span

NamedTriangle named_in(const CanvasFrame& frame) {
    return {*frame.curve, *frame.triangle, frame.state.view.notation};
}

void wish(CanvasFrame& frame, core::Point point, std::string text, const TextStyle& style, LabelSide first) {
    frame.labels.push_back({.place = frame.screen(point),
                            .words = {{std::move(text), style}},
                            .distance = cell_label_distance,
                            .first = first,
                            .crowding = Crowding::cover_symbols});
}

std::string blossom_of(const CanvasFrame& frame, const core::BlossomLabel& label) {
    return frame.state.view.blossom_values ? blossom_by_values(label, frame.state.view.notation)
                                           : blossom_by_indices(label);
}

void label_cell(CanvasFrame& frame, core::CellPlace place, render::Color color) {
    const core::DeBoorCell& cell = frame.triangle->levels[place.level][place.index];
    wish(frame, cell.point, blossom_of(frame, core::de_boor_label(frame.curve->knots(), cell.index, place.level)),
         {.color = color, .size = blossom_size}, LabelSide::right);
}

void label_control_point(CanvasFrame& frame, std::size_t unrolled_index) {
    const auto points = frame.curve->control_points();
    const std::size_t i = unrolled_index % points.size();
    wish(frame, points[i], blossom_of(frame, core::control_point_label(frame.curve->knots(), unrolled_index)),
         {.color = frame.theme.point_text(frame.hue(i)), .size = blossom_size}, LabelSide::lower_right);
}

/// Those of the span have the labels that the construction has, whatever their number; so they come first.
void label_control_points(CanvasFrame& frame) {
    std::vector<bool> is_labeled(std::min(frame.curve->control_points().size(), most_blossoms));
    for (const core::DeBoorCell& cell : frame.triangle->levels[0]) {
        const std::size_t i = cell.index % frame.curve->control_points().size();
        if (i < is_labeled.size() && is_labeled[i]) continue;
        if (i < is_labeled.size()) is_labeled[i] = true;
        label_control_point(frame, cell.index);
    }
    if (frame.curve->control_points().size() > most_blossoms) return;
    for (std::size_t i = 0; i < is_labeled.size(); ++i)
        if (!is_labeled[i]) label_control_point(frame, i);
}

/// The points that get a name.
std::vector<core::CellPlace> named_cells(const CanvasFrame& frame) {
    std::vector<core::CellPlace> cells = marked_cells(frame.state.view, *frame.triangle);
    if (cells.size() > most_named_cells)
        std::erase_if(cells, [&](core::CellPlace cell) { return !is_lit_cell(frame.state, *frame.triangle, cell); });
    return cells;
}

}  // namespace

void draw_inserted_polygon(CanvasFrame& frame) {
    const core::DeBoorTriangle& triangle = *frame.triangle;
    const std::size_t times =
        std::min(shown_level(frame.state.view, frame.curve->degree()), core::insertion_count(triangle));
    if (times == 0) return;
    std::vector<glm::dvec2> places;
    for (const auto [level, index] : core::inserted_polygon(triangle, times))
        places.push_back(frame.screen(triangle.levels[level][index].point));
    frame.pen.line(places, {.color = render::blended(frame.theme.level(times), inserted_share, frame.theme.canvas),
                            .width = inserted_width});
}

void label_construction(CanvasFrame& frame) {
    if (frame.shows(Overlay::blossoms)) return;
    for (const core::CellPlace place : named_cells(frame))
        wish(frame, frame.triangle->levels[place.level][place.index].point, named_in(frame).point(place),
             {.color = frame.theme.level(place.level), .size = construction_name_size}, LabelSide::upper_left);
}

void label_blossoms(CanvasFrame& frame) {
    label_control_points(frame);
    for (const core::CellPlace place : named_cells(frame)) label_cell(frame, place, frame.theme.level(place.level));
    const std::size_t degree = frame.triangle->levels.size() - 1;
    if (shown_level(frame.state.view, frame.curve->degree()) == degree)
        label_cell(frame, {degree, 0}, frame.theme.parameter);
}

}  // namespace batten::editor
