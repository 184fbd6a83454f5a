#include "app/editor/scene/fit_marks.h"

#include <array>

#include "app/editor/pointer/fit_point_drag.h"
#include "app/editor/scene/crowd.h"
#include "app/editor/scene/curve_knots.h"

namespace batten::editor {

namespace {

constexpr std::array square_radii{fit_point_radius, 3.5, 2.0};
constexpr double square_gap = 6.0;
constexpr double most_squares_per_px = 0.5;  // for each pixel of the picture's width
constexpr double larger = 2.0;

Crowd shown_fit_points(const CanvasFrame& frame, const core::FitPoints& fit) {
    std::vector<MarkPlace> places;
    for (const SeenKnot& knot : seen_knots(frame)) {
        const auto i = fit_point_at(fit, knot.value);
        if (!i) continue;
        const glm::dvec2 place = frame.screen(fit.points[*i].place);
        if (frame.pen.reach().contains(place)) places.push_back({*i, place});
    }
    const auto most = static_cast<std::size_t>(most_squares_per_px * frame.pen.size_px().x);
    return settle(frame, std::move(places), {square_radii, square_gap, most});
}

void draw_fit_point(CanvasFrame& frame, glm::dvec2 place, const core::FitPoint& point, double radius, bool is_chosen) {
    const bool is_smooth = point.joint == core::FitJoint::smooth || point.joint == core::FitJoint::tangent;
    frame.pen.symbol(place, {.shape = render::MarkerShape::square,
                             .radius = is_chosen ? fit_point_radius + larger : radius,
                             .fill = is_smooth ? frame.theme.canvas : frame.theme.curve,
                             .outline = is_chosen ? frame.theme.accent : frame.theme.curve,
                             .outline_width = is_chosen ? 2.5 : 1.75});
}

void draw_fit_handles(CanvasFrame& frame, const core::FitPoints& fit) {
    const auto* hovered = std::get_if<HoveredFitHandle>(&frame.state.hover);
    for (const std::size_t i : points_with_handles(fit, frame.state.selection))
        draw_fit_handle(frame, frame.screen(handle_tip(fit, i, HandleEnd::behind)),
                        frame.screen(handle_tip(fit, i, HandleEnd::ahead)), hovered != nullptr && hovered->index == i);
}

}  // namespace

const core::FitPoints* shown_fit(const CanvasFrame& frame) {
    return frame.curve == nullptr ? nullptr : frame.state.shown().active_curve()->fit.get();
}

void draw_fit_marks(CanvasFrame& frame) {
    const core::FitPoints* fit = shown_fit(frame);
    if (fit == nullptr) return;
    draw_fit_handles(frame, *fit);
    const Crowd crowd = shown_fit_points(frame, *fit);
    for (const MarkPlace& mark : crowd.shown)
        draw_fit_point(frame, mark.place, fit->points[mark.index], crowd.radius, false);
    const auto draw_chosen = [&](std::size_t i) {
        if (i >= fit->points.size()) return;
        draw_fit_point(frame, frame.screen(fit->points[i].place), fit->points[i], fit_point_radius, true);
    };
    if (frame.state.selection.fit_point) draw_chosen(*frame.state.selection.fit_point);
    if (const auto* hovered = std::get_if<HoveredFitPoint>(&frame.state.hover)) draw_chosen(hovered->index);
}

void draw_fit_handle(CanvasFrame& frame, glm::dvec2 behind, glm::dvec2 ahead, bool is_lit) {
    const render::Color color = frame.theme.accent;
    frame.pen.segment(behind, ahead, {.color = color, .width = is_lit ? 2.0 : 1.25});
    for (const glm::dvec2 end : {behind, ahead})
        frame.pen.symbol(end, {.radius = is_lit ? 5.5 : 4.5,
                               .fill = frame.theme.canvas,
                               .outline = color,
                               .outline_width = is_lit ? 2.5 : 1.75});
}

}  // namespace batten::editor
