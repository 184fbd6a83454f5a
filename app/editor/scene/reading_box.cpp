#include "app/editor/scene/reading_box.h"

#include <algorithm>
#include <glm/common.hpp>

#include "app/editor/scene/panel_box.h"
#include "app/editor/scene/text_size.h"

namespace batten::editor {

namespace {

constexpr double reading_size = 12.5;
constexpr double reading_distance = 16.0;  // from the place
constexpr double reading_row_height = 20.0;
constexpr double reading_padding = 6.0;
constexpr double width_is_at_most = 1.1;  // times what text_size says

double row_width_px(const Pen& pen, std::string_view text) {
    return width_is_at_most * text_size(text, pen.px(reading_size)).x;
}

/// Adds the row, broken between its parts, or its words, where it is wider than `room_px`.
void add_broken(const Pen& pen, const ReadingRow& row, double room_px, std::vector<ReadingRow>& rows) {
    const std::string_view text = row.text;
    const std::string_view between = text.find(" · ") == std::string_view::npos ? " " : " · ";
    std::size_t begin = 0;
    for (std::size_t end = 0; end < text.size();) {
        const std::size_t next = std::min(text.find(between, end), text.size());
        if (end > begin && row_width_px(pen, text.substr(begin, next - begin)) > room_px) {
            rows.push_back({std::string(text.substr(begin, end - between.size() - begin)), row.color});
            begin = end;
        }
        end = next + between.size();
    }
    rows.push_back({std::string(text.substr(begin)), row.color});
}

render::PixelBox box_beside(const CanvasFrame& frame, glm::dvec2 place, glm::dvec2 size) {
    const double distance = frame.pen.px(reading_distance);
    const glm::dvec2 room = frame.pen.size_px();
    glm::dvec2 corner = place + glm::dvec2(distance);
    if (corner.x + size.x > room.x) corner.x = place.x - distance - size.x;
    if (corner.y + size.y > room.y) corner.y = place.y - distance - size.y;
    corner = glm::max(glm::min(corner, room - size), glm::dvec2(0.0));
    return {corner, corner + size};
}

}  // namespace

double reading_height_px(const Pen& pen, std::size_t row_count) {
    return pen.px(static_cast<double>(row_count) * reading_row_height + reading_padding);
}

void draw_reading(CanvasFrame& frame, glm::dvec2 place, std::span<const ReadingRow> given) {
    const double padding = frame.pen.px(reading_padding);
    std::vector<ReadingRow> rows;
    for (const ReadingRow& row : given) add_broken(frame.pen, row, frame.pen.size_px().x - 2.0 * padding, rows);
    double width = 0.0;
    for (const ReadingRow& row : rows) width = std::max(width, row_width_px(frame.pen, row.text));
    const render::PixelBox box =
        box_beside(frame, place, {width + 2.0 * padding, reading_height_px(frame.pen, rows.size())});
    frame.pen.clear_texts(box);
    draw_panel_box(frame.pen, frame.theme, box);
    double y = box.lower_px.y + 0.5 * (padding + frame.pen.px(reading_row_height));
    for (const ReadingRow& row : rows) {
        frame.pen.text({box.lower_px.x + padding, y}, row.text, {.color = row.color, .size = reading_size});
        y += frame.pen.px(reading_row_height);
    }
}

}  // namespace batten::editor
