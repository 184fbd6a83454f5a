#include "app/editor/scene/place_marks.h"

#include <algorithm>
#include <glm/common.hpp>

#include "app/editor/pointer/direction.h"
#include "app/editor/pointer/place_text.h"
#include "app/editor/pointer/snap.h"
#include "app/editor/scene/reading_box.h"

namespace batten::editor {

namespace {

constexpr double mark_radius = 7.0;

void draw_guide(CanvasFrame& frame, const core::Guide& guide, const Stroke& stroke) {
    const core::Point center(frame.state.view.camera.center);
    const glm::dvec2 middle = frame.screen(nearest_on_guide(guide, center));
    const core::Vector along = direction_of(guide.angle);
    const glm::dvec2 reach = (frame.pen.size_px().x + frame.pen.size_px().y) * glm::dvec2(along.x, -along.y);
    frame.pen.segment(middle - reach, middle + reach, stroke);
    frame.lines.push_back({middle - reach, middle + reach});
}

bool is_exact_place(SnapKind kind) {
    return kind != SnapKind::grid && kind != SnapKind::guides && kind != SnapKind::curve && kind != SnapKind::angles;
}

/// A square around places, a diamond around what lies on lines.
void draw_snap(CanvasFrame& frame, const Snap& snap) {
    for (const SnapLine& line : snap.lines)
        frame.pen.segment(frame.screen(line.from), frame.screen(line.to),
                          {.color = frame.theme.accent, .width = 1.0, .dash = 5.0, .gap = 4.0});
    const glm::dvec2 place = frame.screen(snap.position);
    const double r = frame.pen.px(mark_radius);
    std::vector<glm::dvec2> corners{
        {place.x - r, place.y}, {place.x, place.y - r}, {place.x + r, place.y}, {place.x, place.y + r}};
    if (is_exact_place(snap.kind)) corners = corners_of({place - glm::dvec2(r), place + glm::dvec2(r)});
    frame.pen.outline(std::move(corners), {.color = frame.theme.accent, .width = 2.0});
}

/// From above: what it snaps to, how far it is, what is typed, and what is wrong with that.
std::vector<ReadingRow> rows_of(const CanvasFrame& frame) {
    const Placing& placing = frame.state.placing;
    const Theme& theme = frame.theme;
    std::vector<ReadingRow> rows;
    if (placing.place->snap) rows.push_back({placing.place->snap->label, theme.accent});
    rows.push_back({reading_of(frame.state, *placing.place), theme.text});
    if (placing.typed.is_empty()) return rows;
    rows.push_back({typed_reading(placing.typed, placing.place->typed_for), theme.text});
    if (const std::string problem = typed_problem(frame.state); !problem.empty())
        rows.push_back({problem, theme.error});
    return rows;
}

}  // namespace

void draw_guides(CanvasFrame& frame) {
    const auto* hovered = std::get_if<HoveredGuide>(&frame.state.hover);
    const auto& guides = frame.state.shown().guides;
    for (std::size_t k = 0; k < guides.size(); ++k)
        draw_guide(frame, guides[k],
                   {.color = frame.theme.accent,
                    .width = hovered != nullptr && hovered->index == k ? 2.0 : 1.0,
                    .dash = 12.0,
                    .gap = 4.0});
}

void draw_place(CanvasFrame& frame) {
    const std::optional<ShownPlace>& place = frame.state.placing.place;
    if (!place) return;
    if (place->snap) draw_snap(frame, *place->snap);
    draw_reading(frame, frame.screen(place->position), rows_of(frame));
}

}  // namespace batten::editor
