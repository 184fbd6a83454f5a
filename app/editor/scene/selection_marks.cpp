#include "app/editor/scene/selection_marks.h"

#include <algorithm>

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
constexpr std::size_t most_all_points = 2000;  // of a curve, of which also those are shown that are not selected
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

void draw_part_points(CanvasFrame& frame, const SelectedPart& part) {
    const core::DocumentCurve& entry = frame.state.shown().curves[part.curve];
    const std::size_t count = entry.curve->control_points().size();
    const auto is_selected = [&](std::size_t i) {
        return std::binary_search(part.points.begin(), part.points.end(), i);
    };
    if (count <= most_all_points) {
        draw_polygon(frame, *entry.curve);
        for (std::size_t i = 0; i < count; ++i)
            if (!is_selected(i)) draw_point(frame, entry, part.curve, i, false);
    }
    const std::size_t step = part.points.size() / most_selected_points + 1;
    for (std::size_t k = 0; k < part.points.size(); k += step)
        if (part.points[k] < count) draw_point(frame, entry, part.curve, part.points[k], true);
}

}  // namespace

void draw_selected_others(CanvasFrame& frame) {
    const core::Document& document = frame.state.shown();
    for (const SelectedPart& part : frame.state.selection.others) {
        if (!part.is_whole() || part.curve >= document.curves.size() || !document.curves[part.curve].visible) continue;
        KeptCurve& kept = frame.cache.curve(part.curve, document.curves[part.curve].curve);
        if (const auto line = seen_polylines(frame, kept.strips())) draw_line(frame, *line, band(frame));
    }
}

void draw_selected_active(CanvasFrame& frame) {
    if (frame.state.selection.is_whole && !frame.curve_line.ink) draw_line(frame, frame.curve_line, band(frame));
}

void draw_other_points(CanvasFrame& frame) {
    const SelectedParts& others = frame.state.selection.others;
    for (const std::size_t curve : curves_showing_points(frame.state))
        if (const SelectedPart* part = part_of(others, curve)) draw_part_points(frame, *part);
}

}  // namespace batten::editor
