/// Text with sub- and superscripts, in the notation of render::Label.
#pragma once

#include <string>

#include "app/ui/fonts.h"
#include "render/color.h"

struct ImDrawList;

namespace batten::ui {

/// Width and height in pixels that draw_rich_text needs. `size_px` is the height of the base font.
struct TextSize {
    float width_px = 0.0F;
    float height_px = 0.0F;
};
TextSize rich_text_size(const std::string& text, ImFont* font, float size_px);

/// Draws with the upper left corner at (x, y) of the window: _{..} lower and smaller, ^{..} higher and smaller; one
/// directly after the other are stacked.
void draw_rich_text(ImDrawList* list, const std::string& text, ImFont* font, float size_px, float x_px, float y_px,
                    render::Color color);

/// The same as a Dear ImGui item in the running layout.
void rich_text_item(const std::string& text, ImFont* font, render::Color color);

}  // namespace batten::ui
