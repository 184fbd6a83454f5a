#include "app/editor/scene/joint_marks.h"

#include <glm/geometric.hpp>

#include "app/editor/scene/arrow.h"

namespace batten::editor {

namespace {

constexpr double least_named_vector = 10.0;  // of arrows, whose labels stand beyond it
constexpr double joint_label_size = 14.0;

/// A short line across the median.
void draw_tick(CanvasFrame& frame, glm::dvec2 place, glm::dvec2 along, render::Color color) {
    const glm::dvec2 across = frame.pen.px(4.0) * glm::dvec2(-along.y, along.x);
    frame.pen.segment(place - across, place + across, {.color = color, .width = 1.5});
}

}  // namespace

void draw_vector(CanvasFrame& frame, core::Point place, core::Vector vector, render::Color color,
                 const std::string& name) {
    if (!core::is_finite(place) || !core::is_finite(place + vector)) return;
    const glm::dvec2 from = frame.screen(place);
    const glm::dvec2 to = frame.screen(place + vector);
    draw_arrow(frame.pen, from, to, {.color = color, .width = 2.5});
    if (!name.empty() && glm::distance(from, to) >= frame.pen.px(least_named_vector))
        wish_label(frame, place + vector, name, color, side_toward(to - from));
}

void wish_label(CanvasFrame& frame, core::Point place, const std::string& text, render::Color color, LabelSide first) {
    frame.labels.push_back(
        {.place = frame.screen(place),
         .words = {{text, {.color = color, .size = joint_label_size, .font = render::LabelFont::bold}}},
         .first = first,
         .crowding = Crowding::cover_symbols});
}

void draw_median(CanvasFrame& frame, const core::Anticentroid& joint, render::Color color) {
    const glm::dvec2 vertex = frame.screen(joint.vertex);
    const glm::dvec2 middle = frame.screen(joint.base_middle);
    frame.pen.segment(frame.screen(joint.before), frame.screen(joint.after),
                      {.color = color, .width = 1.5, .dash = 6.0, .gap = 5.0});
    frame.pen.segment(vertex, middle, {.color = color, .width = 2.5});
    const double length = glm::distance(vertex, middle);
    if (!(length >= frame.pen.px(18.0)) || !(length < 1e6)) return;
    const glm::dvec2 along = (middle - vertex) / length;
    draw_tick(frame, vertex + 1.0 / 3.0 * (middle - vertex), along, color);
    draw_tick(frame, vertex + 2.0 / 3.0 * (middle - vertex), along, color);
}

void draw_joint(CanvasFrame& frame, core::Point place, render::Color color) {
    frame.pen.symbol(frame.screen(place),
                     {.radius = 5.0, .fill = frame.theme.canvas, .outline = color, .outline_width = 2.0});
}

bool is_drawable(const core::Anticentroid& joint) {
    return core::is_finite(joint.base_middle) && core::is_finite(joint.anticentroid) &&
           core::is_finite(joint.tangent) && core::is_finite(joint.second_derivative);
}

}  // namespace batten::editor
