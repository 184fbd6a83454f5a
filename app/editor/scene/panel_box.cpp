#include "app/editor/scene/panel_box.h"

namespace batten::editor {

void draw_panel_box(Pen& pen, const Theme& theme, const render::PixelBox& box) {
    const std::vector<glm::dvec2> border = rounded_rectangle(box, pen.px(8.0));
    pen.fill(border, theme.panel);
    pen.outline(border, {.color = theme.line});
}

}  // namespace batten::editor
