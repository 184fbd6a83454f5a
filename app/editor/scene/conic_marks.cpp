#include "app/editor/scene/conic_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/editor/derived/active_conic.h"
#include "app/editor/scene/curve_strokes.h"
#include "app/editor/scene/label_side.h"
#include "core/evaluate/tessellate.h"

namespace batten::editor {

namespace {

constexpr double rest_share = 0.42;
constexpr double rest_width = 2.0;
constexpr double angle_radius = 44.0;
constexpr double conic_label_size = 15.0;

/// The farthest that something seen is from `point`, and more than the piece is long.
double reach_from(const CanvasFrame& frame, const core::ConicArc& arc) {
    const core::Box seen = frame.seen(0.0);
    const core::Point corner = arc.points[1];
    double reach = 2.0 * std::max(arc.legs[0], arc.legs[1]);
    for (const core::Point place :
         {seen.lower, seen.upper, core::Point(seen.lower.x, seen.upper.y), core::Point(seen.upper.x, seen.lower.y)})
        reach = std::max(reach, core::robust_length(place - corner));
    return reach;
}

void draw_rest(CanvasFrame& frame, const core::ConicArc& arc) {
    const double reach = reach_from(frame, arc);
    if (!std::isfinite(reach)) return;
    const render::Color color =
        render::blended(color_of(*frame.state.shown().active_curve(), frame.theme), rest_share, frame.theme.canvas);
    const core::TessellationRequest request{.tolerance = line_tolerance_px(frame) / frame.state.view.camera.scale,
                                            .view = frame.seen(4.0),
                                            .range = {0.0, 1.0}};
    for (const core::Curve& curve : core::complement_of(arc, reach))
        for (const auto& run : core::tessellate(curve, request)) {
            std::vector<glm::dvec2> places;
            for (const core::CurveSample& sample : run) places.push_back(frame.screen(sample.point));
            frame.pen.line(places, {.color = color, .width = rest_width});
        }
}

/// The unit vector on the screen that points from `from` to `to`; none where both are shown in one place.
std::optional<glm::dvec2> direction(glm::dvec2 from, glm::dvec2 to) {
    const glm::dvec2 way = to - from;
    const double length = std::hypot(way.x, way.y);
    return length > 1e-3 ? std::optional(way / length) : std::nullopt;
}

/// The angle a between the first leg and the line to M, which halves the angle of equally long legs.
void draw_half_angle(CanvasFrame& frame, const core::ConicArc& arc) {
    if (!arc.circular_weight) return;
    const glm::dvec2 corner = frame.screen(arc.points[1]);
    const glm::dvec2 middle = frame.screen(arc.chord_middle);
    const auto leg = direction(corner, frame.screen(arc.points[0]));
    const auto halving = direction(corner, middle);
    if (!leg || !halving) return;
    const double way = std::hypot(middle.x - corner.x, middle.y - corner.y);
    const double radius = std::min(frame.pen.px(angle_radius), 0.4 * way);
    const double start = std::atan2(leg->y, leg->x);
    const double turn = std::remainder(std::atan2(halving->y, halving->x) - start, 2.0 * std::numbers::pi);
    std::vector<glm::dvec2> places;
    constexpr int steps = 16;
    for (int k = 0; k <= steps; ++k) {
        const double angle = start + turn * k / steps;
        places.push_back(corner + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    frame.pen.line(places, {.color = frame.theme.parameter, .width = 2.0});
    frame.labels.push_back({.place = places[steps / 2],
                            .words = {{"a", {.color = frame.theme.parameter, .size = conic_label_size}}},
                            .distance = 5.0,
                            .first = side_toward(*leg + *halving),
                            .crowding = Crowding::cover_symbols});
}

/// Keeps labels off a line, at most as many boxes as it takes for what is in the picture.
void keep_free(CanvasFrame& frame, glm::dvec2 a, glm::dvec2 b) {
    constexpr int boxes = 24;
    const glm::dvec2 reach(frame.pen.px(2.5));
    for (int k = 0; k <= boxes; ++k) {
        const glm::dvec2 place = a + (b - a) * (static_cast<double>(k) / boxes);
        if (frame.pen.reach().contains(place)) frame.covered.push_back({place - reach, place + reach});
    }
}

void draw_named_point(CanvasFrame& frame, core::Point point, const LabelWord& name, glm::dvec2 outward) {
    const glm::dvec2 place = frame.screen(point);
    frame.pen.symbol(place,
                     {.radius = 5.0, .fill = name.style.color, .outline = frame.theme.canvas, .outline_width = 1.5});
    frame.labels.push_back({.place = place,
                            .words = {name},
                            .distance = 9.0,
                            .first = side_toward(outward),
                            .crowding = Crowding::cover_symbols});
}

}  // namespace

void draw_conic_below(CanvasFrame& frame) {
    const auto conic = active_conic(*frame.curve, frame.triangle->u);
    if (!conic) return;
    draw_rest(frame, conic->arc);
    const auto& points = conic->arc.points;
    frame.pen.segment(frame.screen(points[0]), frame.screen(points[2]), {.color = frame.theme.dim, .width = 1.5});
    if (conic->has_own_ends) return;
    for (const std::size_t end : {0U, 2U})
        frame.pen.segment(frame.screen(points[end]), frame.screen(points[1]), {.color = frame.theme.dim, .width = 1.5});
}

void draw_conic_above(CanvasFrame& frame) {
    const auto conic = active_conic(*frame.curve, frame.triangle->u);
    if (!conic) return;
    const core::ConicArc& arc = conic->arc;
    const glm::dvec2 middle = frame.screen(arc.chord_middle);
    const glm::dvec2 shoulder = frame.screen(arc.form.shoulder);
    frame.pen.segment(shoulder, frame.screen(arc.points[1]), {.color = frame.theme.dim, .width = 1.5});
    frame.pen.segment(middle, shoulder, {.color = frame.theme.level(2), .width = 4.0});
    keep_free(frame, middle, shoulder);
    draw_half_angle(frame, arc);
    // Beyond the end of the way that M begins, and beside that way at X, on the side of the first point.
    const glm::dvec2 way = shoulder - middle;
    const glm::dvec2 chord = frame.screen(arc.points[0]) - middle;
    const auto named = [](const char* name, render::Color color) {
        return LabelWord{name, {.color = color, .size = conic_label_size, .font = render::LabelFont::bold}};
    };
    draw_named_point(frame, arc.chord_middle, named("M", frame.theme.text), -way);
    draw_named_point(frame, arc.form.shoulder, named("X", frame.theme.level(2)), chord);
}

}  // namespace batten::editor
