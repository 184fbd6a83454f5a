#include "app/editor/scene/curve_knots.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

constexpr double knot_radius = 5.0;
constexpr double stack_distance = 8.5;
constexpr double least_distance = 4.0;
constexpr double covered_distance = 8.0;
constexpr double beside_point = 15.0;

/// Whether stored knot `index` is one of `knot`; the end of a period is its beginning.
bool is_of(const core::KnotVector& knots, std::size_t index, const core::DistinctKnot& knot) {
    const auto stored = knots.stored();
    if (index >= stored.size()) return false;
    const bool is_end_of_period = knots.is_periodic() && stored[index] == knots.domain().upper;
    return stored[index] == knot.value || (is_end_of_period && knot.value == knots.domain().lower);
}

bool is_chosen(const CanvasFrame& frame, const core::DistinctKnot& knot) {
    const core::KnotVector& knots = frame.curve->knots();
    const auto* hovered = std::get_if<HoveredKnot>(&frame.state.hover);
    const auto selected = frame.state.selection.knot;
    return (hovered != nullptr && is_of(knots, hovered->index, knot)) || (selected && is_of(knots, *selected, knot));
}

bool is_lit(const CanvasFrame& frame, const core::DistinctKnot& knot) {
    return std::any_of(frame.lit.knots.begin(), frame.lit.knots.end(),
                       [&](std::size_t index) { return is_of(frame.curve->knots(), index, knot); });
}

/// The direction across the curve in the picture; upwards where the curve stands still.
glm::dvec2 across(const CanvasFrame& frame, double u) {
    const core::Vector along = core::derivatives_at(*frame.curve, u, 1)[1];
    const double speed = core::length(along);
    if (!(speed > 0.0) || !std::isfinite(speed)) return {0.0, -1.0};
    const glm::dvec2 normal = glm::dvec2(along.y, along.x) / speed;
    return normal.y > 0.0 ? -normal : normal;
}

bool is_under_control_point(const CanvasFrame& frame, glm::dvec2 place) {
    if (!frame.shows(Overlay::polygon)) return false;
    const auto points = frame.curve->control_points();
    return std::any_of(points.begin(), points.end(), [&](core::Point point) {
        return glm::distance(frame.screen(point), place) < frame.pen.px(covered_distance);
    });
}

/// One diamond is on the curve; several are spread across it. Where a control point would cover them they stand beside
/// it.
std::vector<glm::dvec2> stack(const CanvasFrame& frame, const core::DistinctKnot& knot) {
    const glm::dvec2 middle = frame.screen(core::point_at(*frame.curve, knot.value));
    if (knot.multiplicity == 1) return {middle};
    const glm::dvec2 direction = across(frame, knot.value);
    const double step = frame.pen.px(stack_distance);
    const double first =
        is_under_control_point(frame, middle) ? frame.pen.px(beside_point) : -0.5 * (knot.multiplicity - 1) * step;
    std::vector<glm::dvec2> places;
    for (int k = 0; k < knot.multiplicity; ++k) places.push_back(middle + (first + k * step) * direction);
    return places;
}

}  // namespace

std::vector<CurveKnot> curve_knots(const CanvasFrame& frame) {
    std::vector<CurveKnot> shown;
    glm::dvec2 last{-1e9};
    for (const core::DistinctKnot& knot : core::distinct_knots(frame.curve->knots())) {
        if (!knot.in_domain) continue;
        const bool chosen = is_chosen(frame, knot);
        const bool lit = chosen || is_lit(frame, knot);
        const bool is_clamped_end = !knot.is_interior && knot.multiplicity > frame.curve->degree();
        if (is_clamped_end && !lit) continue;
        CurveKnot mark{.value = knot.value,
                       .multiplicity = knot.multiplicity,
                       .continuity = knot.continuity,
                       .is_interior = knot.is_interior,
                       .is_lit = lit,
                       .is_chosen = chosen,
                       .places = stack(frame, knot)};
        const bool is_seen = std::any_of(mark.places.begin(), mark.places.end(),
                                         [&](glm::dvec2 place) { return frame.pen.reach().contains(place); });
        if (!is_seen || (!lit && glm::distance(mark.places.front(), last) < frame.pen.px(least_distance))) continue;
        last = mark.places.front();
        shown.push_back(std::move(mark));
    }
    return shown;
}

void draw_curve_knots(CanvasFrame& frame, const std::vector<CurveKnot>& knots) {
    for (const CurveKnot& knot : knots)
        for (const glm::dvec2 place : knot.places)
            frame.pen.symbol(place, {.shape = render::MarkerShape::diamond,
                                     .radius = knot.is_chosen ? knot_radius + 1.5 : knot_radius,
                                     .fill = frame.theme.canvas,
                                     .outline = knot.is_lit ? frame.theme.accent : frame.theme.curve,
                                     .outline_width = knot.is_lit ? 2.0 : 1.5});
}

}  // namespace batten::editor
