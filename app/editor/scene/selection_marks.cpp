#include "app/editor/scene/selection_marks.h"

#include <algorithm>

#include "app/editor/scene/other_curves.h"
#include "app/editor/scene/scene_cache.h"
#include "app/editor/scene/seen_line.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/state/selected_parts.h"

namespace batten::editor {

namespace {

constexpr double band_width = 11.0;
constexpr double band_share = 0.4;
constexpr double polygon_share = 0.6;
constexpr double other_point_radius = 3.5;
constexpr double selected_point_radius = 5.5;
constexpr double hovered_point_radius = 7.0;
constexpr std::size_t most_all_points = 2000;  // of curves of which also those are shown that are not selected
constexpr std::size_t most_selected_points = 4000;

Stroke band(const CanvasFrame& frame) {
    return {.color = render::blended(frame.theme.accent, band_share, frame.theme.canvas), .width = band_width};
}

bool is_hovered(const CanvasFrame& frame, std::size_t curve, std::size_t point) {
    return frame.state.hover == Hover(HoveredOtherPoint{curve, point});
}

void draw_polygon(CanvasFrame& frame, const core::Curve& curve) {
    std::vector<glm::dvec2> places = frame.screen(curve.control_points());
    if (curve.is_periodic()) places.push_back(places.front());
    frame.pen.line(places, {.color = render::blended(frame.theme.polygon, polygon_share, frame.theme.canvas),
                            .width = 1.25,
                            .dash = 6.0,
                            .gap = 5.0});
}

void draw_point(CanvasFrame& frame, const core::DocumentCurve& entry, std::size_t curve, std::size_t i,
                bool is_selected) {
    const double usual = is_selected ? selected_point_radius : other_point_radius;
    const double radius = is_hovered(frame, curve, i) ? hovered_point_radius : usual;
    const glm::dvec2 place = frame.screen(entry.curve->control_points()[i]);
    frame.pen.symbol(place, {.radius = radius,
                             .fill = frame.theme.point(point_hue(entry, i)),
                             .outline = frame.theme.canvas,
                             .outline_width = 1.5});
    if (is_selected)
        frame.pen.symbol(
            place, {.radius = radius + 1.0, .fill = no_color, .outline = frame.theme.accent, .outline_width = 2.0});
}

/// How many control points of other curves are drawn, of all that are and of those that are selected.
struct PointBudget {
    std::size_t left = most_all_points;
    std::size_t step = 1;  // of so many selected ones one is drawn
};

void draw_part_points(CanvasFrame& frame, const SelectedPart& part, PointBudget& budget) {
    const core::DocumentCurve& entry = frame.state.shown().curves[part.curve];
    const std::size_t count = entry.curve->control_points().size();
    const auto is_selected = [&](std::size_t i) {
        return std::binary_search(part.points.begin(), part.points.end(), i);
    };
    if (count <= budget.left) {
        budget.left -= count;
        draw_polygon(frame, *entry.curve);
        for (std::size_t i = 0; i < count; ++i)
            if (!is_selected(i)) draw_point(frame, entry, part.curve, i, false);
    }
    for (std::size_t k = 0; k < part.points.size(); k += budget.step)
        if (part.points[k] < count) draw_point(frame, entry, part.curve, part.points[k], true);
}

}  // namespace

void draw_selected_others(CanvasFrame& frame) {
    const core::Document& document = frame.state.shown();
    std::vector<CurveInColor> curves;
    for (const SelectedPart& part : frame.state.selection.others)
        if (part.is_whole() && part.curve < document.curves.size() && document.curves[part.curve].visible)
            curves.push_back({part.curve, {document.curves[part.curve].curve, band(frame).color}});
    draw_curves(frame, curves, band_width, MovingInk::nothing, frame.cache.selected_others());
}

void draw_selected_active(CanvasFrame& frame) {
    if (frame.state.selection.is_whole && !frame.curve_line.ink) draw_line(frame, frame.curve_line, band(frame));
}

void draw_other_points(CanvasFrame& frame) {
    std::vector<const SelectedPart*> parts;
    std::size_t selected = 0;
    for (const std::size_t curve : curves_showing_points(frame.state))
        if (const SelectedPart* part = part_of(frame.state.selection.others, curve)) {
            parts.push_back(part);
            selected += part->points.size();
        }
    PointBudget budget{.step = selected / most_selected_points + 1};
    for (const SelectedPart* part : parts) draw_part_points(frame, *part, budget);
}

}  // namespace batten::editor
