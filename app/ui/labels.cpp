#include "app/ui/labels.h"

#include <imgui.h>

#include <cmath>

#include "app/ui/imgui_compat.h"
#include "app/ui/interface.h"
#include "app/ui/rich_text.h"

namespace batten::ui {

namespace {

/// A font and the height of its lines for a label's size.
struct LabelType {
    ImFont* font;
    float line_px;
};

LabelType type_of(const render::Label& label, const Fonts& fonts) {
    ImFont* font = font_of(fonts, label.font);
    // The size for which the font was made; close to 11 the small font is sharper than the text font shrunk.
    double made_for_px = (label.font == render::LabelFont::number ? 12.0 : 13.0) * fonts.scale;
    if (label.font == render::LabelFont::text && label.size_px < 11.8 * fonts.scale) {
        font = fonts.small;
        made_for_px = 11.0 * fonts.scale;
    }
    return {font, font_height(font) * label.size_px / static_cast<float>(made_for_px)};
}

float share_left_of(render::Anchor anchor) {
    switch (anchor) {
        case render::Anchor::left:
            return 0.0F;
        case render::Anchor::center:
            return 0.5F;
        case render::Anchor::right:
            return 1.0F;
    }
    return 0.0F;
}

}  // namespace

void draw_label(ImDrawList* list, const render::Label& label, glm::vec2 corner_px, const Fonts& fonts) {
    const LabelType type = type_of(label, fonts);
    const TextSize size = rich_text_size(label.text, type.font, type.line_px);
    const float x = corner_px.x + label.position.x - share_left_of(label.anchor) * size.width_px;
    const float y = corner_px.y + label.position.y - 0.5F * type.line_px;
    draw_rich_text(list, label.text, type.font, type.line_px, std::round(x), y, label.color);
}

void draw_labels(const render::DrawList& picture, const Rectangle& place, const Fonts& fonts) {
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const glm::vec2 low(place.origin_px);
    const glm::vec2 high(place.origin_px + place.size_px);
    list->PushClipRect({low.x, low.y}, {high.x, high.y});
    for (const render::DrawCommand& command : picture.commands)
        if (const auto* label = std::get_if<render::Label>(&command)) draw_label(list, *label, low, fonts);
    list->PopClipRect();
}

}  // namespace batten::ui
