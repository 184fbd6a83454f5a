#include "app/editor/scene/line_crossings.h"

#include <glm/geometric.hpp>

#include "app/editor/pointer/view_handle.h"
#include "app/editor/scene/curve_strokes.h"

namespace batten::editor {

namespace {

constexpr double crossing_radius = 6.0;
constexpr double handle_radius = 7.0;

std::optional<ViewHandle> hovered_handle(const CanvasFrame& frame) {
    const auto* hovered = std::get_if<HoveredHandle>(&frame.state.hover);
    return hovered != nullptr ? std::optional(hovered->handle) : std::nullopt;
}

void draw_contact(CanvasFrame& frame, const core::LineContact& contact) {
    if (contact.where.length() > 0.0 && contact.where.upper <= frame.curve->domain().upper)
        draw_part(frame, contact.where, {.color = frame.theme.parameter, .width = 8.0});
    const bool is_crossing = contact.kind == core::ContactKind::crossing;
    frame.pen.symbol(frame.screen(contact.point), {.radius = crossing_radius,
                                                   .fill = is_crossing ? frame.theme.parameter : frame.theme.canvas,
                                                   .outline = is_crossing ? frame.theme.canvas : frame.theme.parameter,
                                                   .outline_width = is_crossing ? 1.5 : 2.5});
}

void draw_handle(CanvasFrame& frame, core::Point place, ViewHandle handle) {
    const bool is_hovered = hovered_handle(frame) == handle;
    frame.keep_free(frame.screen(place), handle_radius + 1.0);
    frame.pen.symbol(frame.screen(place), {.radius = handle_radius + (is_hovered ? 1.5 : 0.0),
                                           .fill = is_hovered ? frame.theme.accent : frame.theme.canvas,
                                           .outline = frame.theme.accent,
                                           .outline_width = 3.0});
}

}  // namespace

void draw_probe_line(CanvasFrame& frame) {
    const auto line = shown_probe_line(frame.state);
    if (!line) return;
    // From the place nearest to the middle of the picture, so that the ends are near whatever the camera.
    const core::Vector chord = line->second - line->first;
    const core::Vector along = chord / core::robust_length(chord);
    const core::Point middle(frame.state.view.camera.center);
    const core::Point near = line->first + core::dot(middle - line->first, along) * along;
    const glm::dvec2 reach = 2.0 * glm::length(frame.pen.size_px()) * glm::dvec2(along.x, -along.y);
    const glm::dvec2 place = frame.screen(near);
    frame.keep_free(place - 0.25 * reach, place + 0.25 * reach, 4.0);
    frame.pen.segment(place - reach, place + reach,
                      {.color = frame.theme.accent, .width = hovered_handle(frame) ? 3.0 : 2.0});
}

void draw_line_crossings(CanvasFrame& frame) {
    const auto line = shown_probe_line(frame.state);
    if (!line) return;
    if (const auto crossings = frame.state.measured.crossings(*frame.curve, *line)) {
        for (const core::LegCrossing& crossing : crossings->on_polygon)
            frame.pen.symbol(frame.screen(crossing.point), {.shape = render::MarkerShape::square,
                                                            .radius = crossing_radius,
                                                            .fill = frame.theme.canvas,
                                                            .outline = frame.theme.text,
                                                            .outline_width = 2.5});
        for (const core::LineContact& contact : crossings->contacts) draw_contact(frame, contact);
    }
    draw_handle(frame, line->first, ViewHandle::line_first);
    draw_handle(frame, line->second, ViewHandle::line_second);
}

}  // namespace batten::editor
