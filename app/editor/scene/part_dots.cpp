#include "app/editor/scene/part_dots.h"

namespace batten::editor {

namespace {

constexpr double ring_on_axis = 5.0;

template <class Frame>
Symbol dot(const Frame& frame, render::Color ground) {
    return {.radius = 4.5, .fill = frame.theme.level(3), .outline = ground, .outline_width = 1.5};
}

template <class Frame>
Symbol ring_symbol(const Frame& frame, double radius) {
    return {.radius = radius, .fill = no_color, .outline = frame.theme.parameter, .outline_width = 2.5};
}

void draw_ends(CanvasFrame& frame, const EqualParts& parts, const Symbol& symbol) {
    for (const PartEnd& end : parts.ends) frame.pen.symbol(frame.screen(end.point), symbol);
}

void draw_ends(PlotFrame& frame, const EqualParts& parts, const Symbol& symbol) {
    for (const PartEnd& end : parts.ends)
        if (frame.layout.range.contains(end.u)) frame.pen.symbol({frame.x(end.u), frame.layout.bottom_px}, symbol);
}

}  // namespace

void draw_equal_steps(CanvasFrame& frame) {
    const int count = frame.state.view.shape.part_count;
    draw_ends(frame, *frame.state.measured.equal_steps(*frame.curve, count), dot(frame, frame.theme.canvas));
}

void draw_equal_lengths(CanvasFrame& frame) {
    const int count = frame.state.view.shape.part_count;
    draw_ends(frame, *frame.state.measured.equal_lengths(*frame.curve, count), ring_symbol(frame, 7.0));
}

void draw_steps_on_axis(PlotFrame& frame) {
    const int count = frame.state.view.shape.part_count;
    draw_ends(frame, *frame.state.measured.equal_steps(frame.curve, count), dot(frame, frame.theme.panel));
}

void draw_lengths_on_axis(PlotFrame& frame) {
    const int count = frame.state.view.shape.part_count;
    draw_ends(frame, *frame.state.measured.equal_lengths(frame.curve, count), ring_symbol(frame, ring_on_axis));
}

}  // namespace batten::editor
