#include "app/editor/scene/text_row.h"

#include <algorithm>

#include "app/editor/scene/text_size.h"

namespace batten::editor {

bool TextRow::write(Pen& pen, glm::dvec2 position, const std::string& text, const TextStyle& style) {
    const glm::dvec2 size = text_size(text, pen.px(style.size), style.font);
    const double share = style.anchor == render::Anchor::left     ? 0.0
                         : style.anchor == render::Anchor::center ? 0.5
                                                                  : 1.0;
    const double gap = pen.px(8.0);
    const render::Rectangle box{{position.x - share * size.x, position.y - 0.5 * size.y},
                                {position.x + (1.0 - share) * size.x, position.y + 0.5 * size.y}};
    const bool is_free = std::none_of(boxes_.begin(), boxes_.end(), [&](const render::Rectangle& other) {
        return box.lower.x < other.upper.x + gap && other.lower.x < box.upper.x + gap && box.lower.y < other.upper.y &&
               other.lower.y < box.upper.y;
    });
    if (!is_free) return false;
    boxes_.push_back(box);
    pen.text(position, text, style);
    return true;
}

}  // namespace batten::editor
