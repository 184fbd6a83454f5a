#include "app/editor/scene/transform_marks.h"

#include <glm/geometric.hpp>

#include "app/editor/pointer/transform_box.h"
#include "app/editor/scene/grip_marks.h"
#include "core/edit/plane_map.h"

namespace batten::editor {

namespace {

constexpr double grip_radius = 4.5;
constexpr double pivot_radius = 6.0;
constexpr double axis_radius = 4.0;

bool is_lit(const CanvasFrame& frame, TransformGrip grip) {
    const auto* hovered = std::get_if<HoveredGrip>(&frame.state.hover);
    return hovered != nullptr && hovered->grip == grip;
}

/// A ring with a cross; filled where it was chosen, and so stays whatever is done.
void draw_pivot(CanvasFrame& frame, glm::dvec2 place, bool is_own, bool is_lit) {
    const double r = frame.pen.px(is_lit ? pivot_radius + 4.0 : pivot_radius + 2.0);
    const Stroke stroke{.color = frame.theme.accent, .width = 1.5};
    frame.pen.symbol(place, {.radius = pivot_radius,
                             .fill = is_own ? frame.theme.accent : frame.theme.canvas,
                             .outline = frame.theme.accent,
                             .outline_width = 1.5});
    const Stroke inner{.color = is_own ? frame.theme.canvas : frame.theme.accent, .width = 1.5};
    for (const glm::dvec2 along : {glm::dvec2(1.0, 0.0), glm::dvec2(0.0, 1.0)}) {
        frame.pen.segment(place - r * along, place + r * along, stroke);
        frame.pen.segment(place - 0.5 * r * along, place + 0.5 * r * along, inner);
    }
}

/// Squares scale, discs turn.
void draw_handle(CanvasFrame& frame, const TransformBox& box, TransformGrip grip) {
    const glm::dvec2 place = grip_place(frame.state, box, grip);
    if (grip.kind == GripKind::pivot) return draw_pivot(frame, place, box.has_own_pivot, is_lit(frame, grip));
    const bool is_square = grip.kind == GripKind::scale;
    draw_grip(frame, place, is_square ? render::MarkerShape::square : render::MarkerShape::disc, grip_radius,
              is_lit(frame, grip));
}

void draw_lit_side(CanvasFrame& frame, const TransformBox& box) {
    const auto* hovered = std::get_if<HoveredGrip>(&frame.state.hover);
    if (hovered == nullptr || hovered->grip.kind != GripKind::shear) return;
    const auto [kind, x, y] = hovered->grip;
    const TransformGrip one{GripKind::scale, x != 0 ? x : -1, y != 0 ? y : -1};
    const TransformGrip other{GripKind::scale, x != 0 ? x : 1, y != 0 ? y : 1};
    frame.pen.segment(grip_place(frame.state, box, one), grip_place(frame.state, box, other),
                      {.color = frame.theme.accent, .width = 3.0});
}

void draw_dragged_box(CanvasFrame& frame, const TransformBox& box, const core::PlaneMap& map) {
    std::vector<glm::dvec2> corners;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        corners.push_back(frame.screen(core::mapped(map, grip_point(box, {GripKind::inside, x, y}))));
    frame.pen.outline(std::move(corners), {.color = frame.theme.accent, .width = 1.0, .dash = 5.0, .gap = 4.0});
}

}  // namespace

void draw_transform_box(CanvasFrame& frame, const CanvasMode& mode) {
    if (frame.state.tool != Tool::transform) return;
    const auto box = transform_box(frame.state);
    if (!box) return;
    const auto* drag = std::get_if<DraggingTransform>(&mode);
    if (drag != nullptr && drag->has_moved && drag->grip.kind != GripKind::pivot) {
        draw_dragged_box(frame, *box, drag->map);
        if (has_grip(*box, {GripKind::pivot})) draw_pivot(frame, frame.screen(box->pivot), box->has_own_pivot, false);
        return;
    }
    frame.pen.outline(box_corners_px(frame.state, *box), {.color = frame.theme.accent, .width = 1.0});
    draw_lit_side(frame, *box);
    for (const TransformGrip grip : visible_grips(*box)) draw_handle(frame, *box, grip);
}

void reserve_transform_box(CanvasFrame& frame) {
    if (frame.state.tool != Tool::transform) return;
    const auto box = transform_box(frame.state);
    if (!box) return;
    const glm::dvec2 reach(frame.pen.px(pivot_radius + 2.0));
    for (const TransformGrip grip : visible_grips(*box)) {
        const glm::dvec2 place = grip_place(frame.state, *box, grip);
        frame.covered.push_back({place - reach, place + reach});
    }
    std::vector<glm::dvec2> sides = box_corners_px(frame.state, *box);
    sides.push_back(sides.front());
    frame.lines.push_back(std::move(sides));
}

void draw_axis_pick(CanvasFrame& frame) {
    const auto& pick = frame.state.axis_pick;
    const auto& place = frame.state.placing.place;
    if (!pick) return;
    const Symbol mark{
        .radius = axis_radius, .fill = frame.theme.canvas, .outline = frame.theme.accent, .outline_width = 2.0};
    if (pick->first && place) {
        const glm::dvec2 first = frame.screen(*pick->first);
        const glm::dvec2 way = frame.screen(place->position) - first;
        const double length = glm::length(way);
        // Well beyond the picture on both sides.
        const double reach = frame.pen.size_px().x + frame.pen.size_px().y + glm::length(first);
        if (length > 0.0)
            frame.pen.segment(first - reach / length * way, first + reach / length * way,
                              {.color = frame.theme.accent, .width = 1.5, .dash = 10.0, .gap = 4.0});
    }
    if (pick->first) frame.pen.symbol(frame.screen(*pick->first), mark);
    if (place) frame.pen.symbol(frame.screen(place->position), mark);
}

}  // namespace batten::editor
