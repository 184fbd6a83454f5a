#include "app/editor/scene/handlebar_marks.h"

#include "app/editor/pointer/handlebar.h"

namespace batten::editor {

namespace {

constexpr double middle_radius = 6.0;
constexpr double tip_radius = 5.0;
constexpr double larger_when_lit = 1.5;

bool is_hovered_part(const CanvasFrame& frame, HandlebarPart part) {
    const auto* hovered = std::get_if<HoveredHandlebar>(&frame.state.hover);
    return hovered != nullptr && hovered->part == part;
}

void draw_part(CanvasFrame& frame, glm::dvec2 place, HandlebarPart part) {
    const bool is_lit = is_hovered_part(frame, part);
    const bool is_middle = part == HandlebarPart::middle;
    frame.pen.symbol(place, {.shape = is_middle ? render::MarkerShape::square : render::MarkerShape::disc,
                             .radius = (is_middle ? middle_radius : tip_radius) + (is_lit ? larger_when_lit : 0.0),
                             .fill = frame.theme.canvas,
                             .outline = frame.theme.accent,
                             .outline_width = is_lit ? 2.5 : 2.0});
}

}  // namespace

void draw_handlebar(CanvasFrame& frame) {
    const auto bar = shown_handlebar(frame.state);
    if (!bar) return;
    const glm::dvec2 middle = frame.screen(bar->place);
    const auto draw_arm = [&](HandlebarPart part) {
        const auto tip = place_of(*bar, part);
        if (!tip) return;
        frame.pen.segment(middle, frame.screen(*tip), {.color = frame.theme.accent, .width = 1.5});
        draw_part(frame, frame.screen(*tip), part);
        frame.keep_free(frame.screen(*tip), tip_radius);
    };
    draw_arm(HandlebarPart::behind);
    draw_arm(HandlebarPart::ahead);
    draw_part(frame, middle, HandlebarPart::middle);
    frame.keep_free(middle, middle_radius);
}

}  // namespace batten::editor
