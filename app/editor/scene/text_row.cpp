#include "app/editor/scene/text_row.h"

#include <algorithm>

#include "app/editor/scene/text_size.h"

namespace batten::editor {

namespace {

constexpr double row_edge_distance = 3.0;

}  // namespace

bool TextRow::write(Pen& pen, glm::dvec2 position, const std::string& text, const TextStyle& style) {
    const glm::dvec2 size = text_size(text, pen.px(style.size), style.font);
    const double share = style.anchor == render::Anchor::left     ? 0.0
                         : style.anchor == render::Anchor::center ? 0.5
                                                                  : 1.0;
    const double gap = pen.px(8.0);
    const double least_x = share * size.x + pen.px(row_edge_distance);
    const double most_x = pen.size_px().x - (1.0 - share) * size.x - pen.px(row_edge_distance);
    if (least_x <= most_x) position.x = std::clamp(position.x, least_x, most_x);
    const render::PixelBox box{{position.x - share * size.x, position.y - 0.5 * size.y},
                               {position.x + (1.0 - share) * size.x, position.y + 0.5 * size.y}};
    const bool is_free = std::none_of(boxes_.begin(), boxes_.end(), [&](const render::PixelBox& other) {
        return box.lower_px.x < other.upper_px.x + gap && other.lower_px.x < box.upper_px.x + gap &&
               box.lower_px.y < other.upper_px.y && other.lower_px.y < box.upper_px.y;
    });
    if (!is_free) return false;
    boxes_.push_back(box);
    pen.text(position, text, style);
    return true;
}

}  // namespace batten::editor
