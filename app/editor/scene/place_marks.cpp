#include "app/editor/scene/place_marks.h"

#include <algorithm>
#include <glm/common.hpp>

#include "app/editor/pointer/place_text.h"
#include "app/editor/pointer/snap.h"
#include "app/editor/scene/text_size.h"

namespace batten::editor {

namespace {

constexpr double mark_radius = 7.0;
constexpr double label_size = 12.5;
constexpr double label_distance = 16.0;  // from the place
constexpr double row_height = 20.0;
constexpr double ground_padding = 6.0;
constexpr double width_is_at_most = 1.1;  // times what text_size says
constexpr double place_ground_opacity = 0.94;

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

struct Row {
    std::string text;
    render::Color color;
};

/// From above: what it snaps to, how far it is, what is typed, and what is wrong with that.
std::vector<Row> rows_of(const CanvasFrame& frame) {
    const Placing& placing = frame.state.placing;
    const Theme& theme = frame.theme;
    std::vector<Row> rows;
    if (placing.place->snap) rows.push_back({placing.place->snap->label, theme.accent});
    rows.push_back({reading_of(frame.state, *placing.place), theme.text});
    if (placing.typed.is_empty()) return rows;
    rows.push_back({typed_reading(placing.typed), theme.text});
    if (const std::string problem = typed_problem(placing); !problem.empty()) rows.push_back({problem, theme.error});
    return rows;
}

/// Below and to the right of `place`, where there is room, else on the other side.
render::PixelBox box_beside(const CanvasFrame& frame, glm::dvec2 place, glm::dvec2 size) {
    const double distance = frame.pen.px(label_distance);
    const glm::dvec2 room = frame.pen.size_px();
    glm::dvec2 corner = place + glm::dvec2(distance);
    if (corner.x + size.x > room.x) corner.x = place.x - distance - size.x;
    if (corner.y + size.y > room.y) corner.y = place.y - distance - size.y;
    corner = glm::max(glm::min(corner, room - size), glm::dvec2(0.0));
    return {corner, corner + size};
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
    const std::vector<Row> rows = rows_of(frame);
    const double padding = frame.pen.px(ground_padding);
    double width = 0.0;
    for (const Row& row : rows)
        width = std::max(width, width_is_at_most * text_size(row.text, frame.pen.px(label_size)).x);
    const double height = static_cast<double>(rows.size()) * frame.pen.px(row_height);
    const render::PixelBox box =
        box_beside(frame, frame.screen(place->position), {width + 2.0 * padding, height + padding});
    frame.pen.fill(rounded_rectangle(box, padding), render::faded(frame.theme.panel, place_ground_opacity));
    double y = box.lower_px.y + 0.5 * (padding + frame.pen.px(row_height));
    for (const Row& row : rows) {
        frame.pen.text({box.lower_px.x + padding, y}, row.text, {.color = row.color, .size = label_size});
        y += frame.pen.px(row_height);
    }
}

}  // namespace batten::editor
