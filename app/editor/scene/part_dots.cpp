#include "app/editor/scene/part_dots.h"

namespace batten::editor {

namespace {

void draw_ends(CanvasFrame& frame, const EqualParts& parts, const Symbol& symbol) {
    for (const PartEnd& end : parts.ends) frame.pen.symbol(frame.screen(end.point), symbol);
}

}  // namespace

void draw_equal_steps(CanvasFrame& frame) {
    const int count = frame.state.view.shape.part_count;
    draw_ends(frame, *frame.state.measured.equal_steps(*frame.curve, count),
              {.radius = 4.5, .fill = frame.theme.level(3), .outline = frame.theme.canvas, .outline_width = 1.5});
}

void draw_equal_lengths(CanvasFrame& frame) {
    const int count = frame.state.view.shape.part_count;
    draw_ends(frame, *frame.state.measured.equal_lengths(*frame.curve, count),
              {.radius = 7.0, .fill = no_color, .outline = frame.theme.parameter, .outline_width = 2.5});
}

}  // namespace batten::editor
