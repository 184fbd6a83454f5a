#include "app/editor/scene/handlebar_marks.h"

#include "app/editor/pointer/handlebar.h"
#include "app/editor/scene/grip_marks.h"

namespace batten::editor {

namespace {

constexpr double middle_radius = 6.0;
constexpr double tip_radius = 5.0;

bool is_hovered_part(const CanvasFrame& frame, HandlebarPart part) {
    const auto* hovered = std::get_if<HoveredHandlebar>(&frame.state.hover);
    return hovered != nullptr && hovered->part == part;
}

void draw_part(CanvasFrame& frame, glm::dvec2 place, HandlebarPart part) {
    const bool is_middle = part == HandlebarPart::middle;
    draw_grip(frame, place, is_middle ? render::MarkerShape::square : render::MarkerShape::disc,
              is_middle ? middle_radius : tip_radius, is_hovered_part(frame, part));
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
