#include "app/editor/scene/hodograph_inset.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "app/editor/scene/arrow.h"
#include "app/editor/scene/curve_strokes.h"
#include "app/editor/scene/inset_map.h"
#include "app/editor/scene/panel_box.h"
#include "app/editor/scene/text_size.h"
#include "core/base/sentence.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

constexpr double hodograph_padding = 14.0;
constexpr double hodograph_title_height = 16.0;
constexpr double places_per_px = 4.0;  // of the picture's width
constexpr std::size_t most_sampled_spans = 2000;
constexpr std::size_t most_differentiated_points =
    20000;  // large hodographs of longer curves are sampled, at a bounded cost

std::size_t all_span_count(const core::Curve& curve) {
    return curve.knots().size() - 2 * static_cast<std::size_t>(curve.degree()) - 1;
}

std::size_t sampling_stride(const core::Curve& curve) {
    return all_span_count(curve) / most_sampled_spans + 1;
}

core::Vector derivative(const core::Curve& curve, std::size_t order, double u, core::Side side = core::Side::right) {
    return core::derivatives_at(curve, u, static_cast<int>(order), side)[order];
}

/// The derivative over each non-empty span, from its one-sided value at the start to that at the end, where the
/// hodograph is too large for a curve; of very many spans some.
core::PointRuns sampled_runs(const core::Curve& curve, std::size_t order) {
    const core::KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t spans = all_span_count(curve);
    const int steps = std::clamp(320 / static_cast<int>(spans), 4, 40);
    core::PointRuns runs;
    for (std::size_t s = p; s < p + spans; s += sampling_stride(curve)) {
        if (knots[s] == knots[s + 1]) continue;
        auto& run = runs.emplace_back();
        for (int k = 0; k <= steps; ++k) {
            const double u = k == steps ? knots[s + 1] : knots[s] + (knots[s + 1] - knots[s]) * k / steps;
            const core::Vector v = derivative(curve, order, u, k == steps ? core::Side::left : core::Side::right);
            if (core::is_finite(v)) run.push_back(core::tip_of(v));
        }
    }
    return runs;
}

// With the origin, from which all are seen.
core::Box box_of(const core::PointRuns& runs) {
    core::Box box;
    box.include({0.0, 0.0});
    for (const auto& run : runs)
        for (const core::Point tip : run) box.include(tip);
    return box;
}

core::Box with_origin(core::Box box) {
    box.include({0.0, 0.0});
    return box;
}

void draw_axes(Pen& pen, const Theme& theme, const render::PixelBox& area, glm::dvec2 origin) {
    pen.segment({area.lower_px.x, origin.y}, {area.upper_px.x, origin.y}, {.color = theme.line});
    pen.segment({origin.x, area.lower_px.y}, {origin.x, area.upper_px.y}, {.color = theme.line});
}

/// What is drawn of a derivative.
struct Hodograph {
    std::size_t order = 1;
    core::CurveStrips* strips = nullptr;  ///< null where it cannot be drawn as a curve
    core::PointRuns polygon{};            ///< its control polygon, in parts where it is torn; none of very many points

    const char* name() const { return order == 1 ? "C′(u)" : "C″(u)"; }
};

/// The strips where all numbers are finite and the curve is not too long.
core::CurveStrips* strips_of(const CanvasFrame& frame, std::size_t order) {
    const bool is_large = order == 2 || frame.curve->is_rational();  // several control points for each of the curve
    if (is_large && frame.curve->control_points().size() > most_differentiated_points) return nullptr;
    core::CurveStrips* strips = frame.kept->hodograph(order);
    return strips != nullptr && core::is_finite(strips->box().lower) && core::is_finite(strips->box().upper) ? strips
                                                                                                             : nullptr;
}

/// The control polygon, which ends and begins anew at tears.
core::PointRuns polygon_of(const core::Curve& curve) {
    const auto points = curve.control_points();
    const auto degree = static_cast<std::size_t>(curve.degree());
    core::PointRuns runs;
    if (points.size() > most_hodograph_points) return runs;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool is_torn = !curve.is_periodic() && curve.knots()[i] == curve.knots()[i + degree];
        if (i == 0 || is_torn) runs.emplace_back();
        runs.back().push_back(points[i]);
    }
    if (curve.is_periodic()) runs.back().push_back(points.front());
    return runs;
}

Hodograph hodograph_of(const CanvasFrame& frame, std::size_t order) {
    Hodograph hodograph{.order = order, .strips = strips_of(frame, order)};
    if (hodograph.strips != nullptr) hodograph.polygon = polygon_of(*hodograph.strips->curve());
    return hodograph;
}

std::string title_of(const CanvasFrame& frame, const Hodograph& hodograph) {
    const core::Place name("name", hodograph.name());
    const std::size_t spans = all_span_count(*frame.curve);
    const std::size_t stride = sampling_stride(*frame.curve);
    if (hodograph.strips == nullptr && stride > 1)
        return core::sentence("{name} on {shown} of {count} spans",
                              {name, {"shown", (spans - 1) / stride + 1}, {"count", spans}});
    if (hodograph.strips == nullptr || hodograph.polygon.empty())
        return core::sentence("{name} without its polygon", {name});
    if (hodograph.strips->curve()->is_rational())
        return core::sentence("{name}, rational, degree {degree}",
                              {name, {"degree", hodograph.strips->curve()->degree()}});
    return core::sentence("{name} and its polygon", {name});
}

std::vector<glm::dvec2> places_of(const std::vector<core::Point>& run, const InsetMap& map) {
    std::vector<glm::dvec2> places;
    places.reserve(run.size());
    for (const core::Point tip : run) places.push_back(map(tip));
    return places;
}

/// The polylines of the hodograph, so near that no feature of a pixel is missed; none where these have too many places.
std::optional<core::PointRuns> hodograph_runs(const CanvasFrame& frame, const Hodograph& hodograph,
                                              const render::PixelBox& area) {
    core::CurveStrips* strips = hodograph.strips;
    if (strips == nullptr) return sampled_runs(*frame.curve, hodograph.order);
    const InsetMap map(area, with_origin(strips->box()));
    const double tolerance =
        std::max(line_tolerance_px(frame) / std::max(map.scale(), std::numeric_limits<double>::min()),
                 std::numeric_limits<double>::min());
    const auto most = static_cast<std::size_t>(places_per_px * frame.state.view.parts.fineness * frame.pen.size_px().x);
    return strips->runs({tolerance, strips->box(), most}, strips->curve()->domain());
}

void draw_inked(CanvasFrame& frame, const core::CurveStrips& strips, const InsetMap& map, const Stroke& stroke) {
    const InkPlace place = ink_place(frame, stroke);
    auto ink = std::make_shared<render::CoverageMap>(place.size_px);
    strips.visit_chords(chord_request(place, {ink_tolerance_px / map.scale(), strips.box()}, map, *ink),
                        strips.curve()->domain());
    frame.pen.ink(ink, stroke.color);
}

/// The control point that the hovered leg makes, where each makes one, or the hovered one itself.
std::optional<std::size_t> lit_point(const CanvasFrame& frame, const Hodograph& hodograph) {
    if (!has_differences(*hodograph.strips->curve(), *frame.curve, hodograph.order)) return std::nullopt;
    const auto* hovered = std::get_if<HoveredHodograph>(&frame.state.hover);
    if (hovered != nullptr && hovered->order == hodograph.order) return hovered->index;
    return hodograph.order == 1 ? hovered_leg(frame.state.hover) : std::nullopt;
}

void draw_polygon(CanvasFrame& frame, const Hodograph& hodograph, const InsetMap& map) {
    std::size_t i = 0;
    const auto lit = hodograph.strips == nullptr ? std::nullopt : lit_point(frame, hodograph);
    for (const auto& run : hodograph.polygon) {
        const std::vector<glm::dvec2> places = places_of(run, map);
        frame.pen.line(places, {.color = frame.theme.polygon, .width = 1.0});
        for (const glm::dvec2 place : places) {
            const bool is_lit = lit == i++;
            frame.pen.symbol(place, {.radius = is_lit ? 4.5 : 2.75,
                                     .fill = is_lit ? frame.theme.accent : frame.theme.polygon,
                                     .outline = frame.theme.panel,
                                     .outline_width = 1.0});
        }
    }
}

void draw_vector_at_parameter(CanvasFrame& frame, std::size_t order, const InsetMap& map) {
    const core::Point now = core::tip_of(derivative(*frame.curve, order, frame.triangle->u));
    if (!core::is_finite(now)) return;
    draw_arrow(frame.pen, map({0.0, 0.0}), map(now), {.color = frame.theme.parameter, .width = 1.5});
    frame.pen.symbol(
        map(now), {.radius = 4.5, .fill = frame.theme.parameter, .outline = frame.theme.panel, .outline_width = 1.5});
}

void draw_hovered_place(CanvasFrame& frame, std::size_t order, const InsetMap& map) {
    const auto u = hovered_u(frame.state.hover);
    if (!u) return;
    const core::Vector there = derivative(*frame.curve, order, *u);
    if (core::is_finite(there)) frame.pen.symbol(map(core::tip_of(there)), hovered_place_symbol(frame.theme));
}

void draw_inset(CanvasFrame& frame, const render::PixelBox& box, std::size_t order) {
    const Hodograph hodograph = hodograph_of(frame, order);
    Pen& pen = frame.pen;
    const Theme& theme = frame.theme;
    draw_panel_box(pen, theme, box);
    const render::PixelBox area = hodograph_area(box, pen.px(1.0));
    const std::string title = title_of(frame, hodograph);
    const TextStyle style{.color = theme.dim, .size = 11.5};
    const bool has_room = text_size(title, pen.px(style.size)).x <= area.upper_px.x - area.lower_px.x;
    pen.text({area.lower_px.x, box.lower_px.y + pen.px(15.0)}, has_room ? title : hodograph.name(), style);
    const std::optional<core::PointRuns> runs = hodograph_runs(frame, hodograph, area);
    core::Box drawn = runs ? box_of(*runs) : with_origin(hodograph.strips->box());
    for (const auto& run : hodograph.polygon)
        for (const core::Point point : run) drawn.include(point);
    const InsetMap map(area, drawn);
    draw_axes(pen, theme, area, map({0.0, 0.0}));
    draw_polygon(frame, hodograph, map);
    const Stroke stroke{.color = theme.curve, .width = 1.75};
    if (!runs) draw_inked(frame, *hodograph.strips, map, stroke);
    if (runs)
        for (const auto& run : *runs) pen.line(places_of(run, map), stroke);
    draw_vector_at_parameter(frame, order, map);
    draw_hovered_place(frame, order, map);
}

}  // namespace

render::PixelBox hodograph_area(const render::PixelBox& box, double scale) {
    const glm::dvec2 padding(scale * hodograph_padding);
    return {box.lower_px + padding + glm::dvec2(0.0, scale * hodograph_title_height), box.upper_px - padding};
}

bool has_differences(const core::Curve& hodograph, const core::Curve& curve, std::size_t order) {
    const std::size_t points = curve.control_points().size();
    const std::size_t differences = curve.is_periodic() ? points : points - std::min(points, order);
    return !curve.is_rational() && hodograph.control_points().size() == differences;
}

void draw_hodograph_inset(CanvasFrame& frame, const render::PixelBox& box) {
    draw_inset(frame, box, 1);
}

void draw_second_hodograph_inset(CanvasFrame& frame, const render::PixelBox& box) {
    draw_inset(frame, box, 2);
}

}  // namespace batten::editor
