#include "app/editor/scene/grip_marks.h"

namespace batten::editor {

void draw_grip(CanvasFrame& frame, glm::dvec2 place_px, render::MarkerShape shape, double radius, bool is_lit) {
    constexpr double larger_when_lit = 1.5;
    frame.pen.symbol(place_px, {.shape = shape,
                                .radius = radius + (is_lit ? larger_when_lit : 0.0),
                                .fill = is_lit ? frame.theme.accent : frame.theme.canvas,
                                .outline = frame.theme.accent,
                                .outline_width = 1.5});
}

}  // namespace batten::editor
