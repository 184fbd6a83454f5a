#include "app/editor/scene/halves.h"

#include <algorithm>

#include "core/evaluate/de_boor_polygons.h"
#include "core/evaluate/tessellate.h"

namespace batten::editor {

namespace {

constexpr double half_band_width = 10.0;
constexpr double half_band_share = 0.45;  // of the color, in the canvas
constexpr double half_leg_width = 4.5;
constexpr double half_outline_width = 2.5;
constexpr double half_point_radius = 5.5;
constexpr double places_of_half = 0.5;  // for each pixel of the picture's width
constexpr std::size_t most_legs = 500;  // of a polygon, to each side of the span

using Cells = std::vector<core::CellPlace>;

/// One of the two.
struct CurveHalf {
    Cells cells;
    core::Interval range;        ///< of its parameters
    core::Interval whole_spans;  ///< of these those of spans that u does not cut
    render::Color color;
};

std::vector<core::Point> points_of(const core::DeBoorTriangle& triangle, const Cells& cells) {
    std::vector<core::Point> points;
    for (const auto [level, index] : cells) points.push_back(triangle.levels[level][index].point);
    return points;
}

/// The control points that are the part's as they are: those before the span's, or those after them.
std::vector<core::Point> points_before(const CanvasFrame& frame, std::size_t first) {
    const auto all = frame.curve->control_points();
    const std::size_t begin = first > most_legs ? first - most_legs : 0;
    return {all.begin() + static_cast<std::ptrdiff_t>(begin), all.begin() + static_cast<std::ptrdiff_t>(first)};
}
std::vector<core::Point> points_after(const CanvasFrame& frame, std::size_t last) {
    const auto all = frame.curve->control_points();
    const std::size_t end = std::min(last + 1 + most_legs, all.size());
    return {all.begin() + static_cast<std::ptrdiff_t>(last + 1), all.begin() + static_cast<std::ptrdiff_t>(end)};
}

void draw_part_of_curve(CanvasFrame& frame, const CurveHalf& part) {
    const Stroke stroke{.color = render::blended(part.color, half_band_share, frame.theme.canvas),
                        .width = half_band_width};
    if (part.whole_spans.lower < part.whole_spans.upper)
        draw_line(frame, seen_part(frame, frame.kept->strips(), part.whole_spans, places_of_half, stroke), stroke);
    const core::KnotVector& knots = frame.curve->knots();
    const std::size_t s = frame.triangle->span;
    const core::Interval cut{std::max(part.range.lower, knots[s]), std::min(part.range.upper, knots[s + 1])};
    if (!(cut.lower < cut.upper)) return;
    const double tolerance = line_tolerance_px(frame) / frame.state.view.camera.scale;
    for (const auto& run :
         core::tessellate(*frame.curve, {tolerance, frame.seen(frame.pen.px(half_band_width)), cut})) {
        std::vector<glm::dvec2> places;
        for (const core::CurveSample& sample : run) places.push_back(frame.screen(sample.point));
        frame.pen.line(places, stroke);
    }
}

void draw_polygon(CanvasFrame& frame, const std::vector<core::Point>& points, render::Color color) {
    frame.pen.line(frame.screen(points), {.color = color, .width = half_leg_width});
}

void draw_new_points(CanvasFrame& frame, const CurveHalf& part) {
    for (const auto [level, index] : part.cells)
        if (level > 0)
            frame.pen.symbol(frame.screen(frame.triangle->levels[level][index].point),
                             {.radius = half_point_radius,
                              .fill = frame.theme.canvas,
                              .outline = part.color,
                              .outline_width = half_outline_width});
}

struct Halves {
    CurveHalf before;
    CurveHalf after;
};

Halves halves_of(const CanvasFrame& frame) {
    const core::DeBoorTriangle& triangle = *frame.triangle;
    core::SplitPolygons polygons = core::split_polygons(*frame.curve, triangle);
    const core::Interval domain = frame.curve->domain();
    const core::KnotVector& knots = frame.curve->knots();
    const HalfColors colors = half_colors(frame.theme);
    return {
        {std::move(polygons.before), {domain.lower, triangle.u}, {domain.lower, knots[triangle.span]}, colors.before},
        {std::move(polygons.after),
         {triangle.u, domain.upper},
         {knots[triangle.span + 1], domain.upper},
         frame.curve->is_periodic() ? colors.before : colors.after}};
}

}  // namespace

HalfColors half_colors(const Theme& theme) {
    return {theme.accent, theme.palette[5]};
}

void draw_halves(CanvasFrame& frame) {
    const core::DeBoorTriangle& triangle = *frame.triangle;
    const auto [before, after] = halves_of(frame);
    std::vector<core::Point> before_points = points_of(triangle, before.cells);
    std::vector<core::Point> after_points = points_of(triangle, after.cells);
    if (!frame.curve->is_periodic()) {
        const std::vector<core::Point> first = points_before(frame, triangle.levels[0].front().index);
        const std::vector<core::Point> last = points_after(frame, triangle.levels[0].back().index);
        before_points.insert(before_points.begin(), first.begin(), first.end());
        after_points.insert(after_points.end(), last.begin(), last.end());
    }
    draw_part_of_curve(frame, before);
    draw_part_of_curve(frame, after);
    draw_polygon(frame, before_points, before.color);
    draw_polygon(frame, after_points, after.color);
}

void draw_points_of_halves(CanvasFrame& frame) {
    const auto [before, after] = halves_of(frame);
    draw_new_points(frame, before);
    draw_new_points(frame, after);
}

}  // namespace batten::editor
