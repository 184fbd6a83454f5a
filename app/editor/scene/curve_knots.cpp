#include "app/editor/scene/curve_knots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/scene/fit_marks.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

constexpr std::array knot_radii{5.0, 3.5, 2.5};
constexpr double knot_gap = 7.0;
constexpr double merged_knots = 24.0;      // sixteen spans that are shorter together are seen as one
constexpr double most_knots_per_px = 0.5;  // diamonds for each pixel of the picture's width
constexpr double stack_distance = 8.5;
constexpr std::size_t few_hidden = 12;  // where knots of a small curve meet
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

/// One diamond is on the curve, at `middle`; several are spread across it. Where a control point would cover them they
/// stand beside it.
std::vector<glm::dvec2> stack(const CanvasFrame& frame, const ShownPoints& points, const core::DistinctKnot& knot,
                              glm::dvec2 middle) {
    if (knot.multiplicity == 1) return {middle};
    const glm::dvec2 direction = across(frame, knot.value);
    const double step = frame.pen.px(stack_distance);
    const bool is_covered = has_point_near(frame, points, middle, frame.pen.px(covered_distance));
    const double first = is_covered ? frame.pen.px(beside_point) : -0.5 * (knot.multiplicity - 1) * step;
    std::vector<glm::dvec2> places;
    for (int k = 0; k < knot.multiplicity; ++k) places.push_back(middle + (first + k * step) * direction);
    return places;
}

core::DistinctKnot distinct_knot(const core::KnotVector& knots, double value) {
    const core::Interval domain = knots.domain();
    core::DistinctKnot knot{.value = value, .multiplicity = knots.multiplicity(value), .in_domain = true};
    knot.continuity = knots.degree() - knot.multiplicity;
    knot.is_interior = knots.is_periodic() || (domain.lower < value && value < domain.upper);
    return knot;
}

/// The mark of a knot where it is seen; none for the ends of a clamped curve unless they are lit.
std::optional<CurveKnot> mark_of(const CanvasFrame& frame, const ShownPoints& points, const SeenKnot& candidate) {
    const core::DistinctKnot knot = distinct_knot(frame.curve->knots(), candidate.value);
    const bool chosen = is_chosen(frame, knot);
    const bool lit = chosen || is_lit(frame, knot);
    const bool is_clamped_end = !knot.is_interior && knot.multiplicity > frame.curve->degree();
    if (is_clamped_end && !lit) return std::nullopt;
    CurveKnot mark{.value = knot.value,
                   .multiplicity = knot.multiplicity,
                   .continuity = knot.continuity,
                   .is_interior = knot.is_interior,
                   .is_lit = lit,
                   .is_chosen = chosen,
                   .places = stack(frame, points, knot, frame.screen(candidate.point))};
    const bool is_seen = std::any_of(mark.places.begin(), mark.places.end(),
                                     [&](glm::dvec2 place) { return frame.pen.reach().contains(place); });
    if (!is_seen) return std::nullopt;
    return mark;
}

/// Makes marks smaller or fewer where they are too many; lit ones stay.
void settle_knots(const CanvasFrame& frame, ShownKnots& shown) {
    std::vector<MarkPlace> places;
    for (std::size_t k = 0; k < shown.knots.size(); ++k)
        if (frame.pen.reach().contains(shown.knots[k].places.front()))
            places.push_back({k, shown.knots[k].places.front()});
    const auto most = static_cast<std::size_t>(most_knots_per_px * frame.pen.size_px().x);
    const Crowd crowd = settle(frame, std::move(places), {knot_radii, knot_gap, most});
    shown.radius = crowd.radius;
    if (!crowd.is_thinned) return;
    std::vector<bool> is_kept(shown.knots.size(), false);
    for (const MarkPlace& place : crowd.shown) is_kept[place.index] = true;
    std::vector<CurveKnot> kept;
    for (std::size_t k = 0; k < shown.knots.size(); ++k)
        if (is_kept[k] || shown.knots[k].is_lit) kept.push_back(std::move(shown.knots[k]));
    shown.knots = std::move(kept);
}

}  // namespace

std::vector<SeenKnot> seen_knots(const CanvasFrame& frame) {
    const core::KnotVector& knots = frame.curve->knots();
    std::vector<SeenKnot> found;
    const auto add = [&](double u) { found.push_back({u, core::point_at(*frame.curve, u)}); };
    const double margin = frame.pen.size_px().x - frame.pen.reach().upper_px.x;
    frame.kept->strips().visit_spans(frame.seen(-margin), frame.pen.px(merged_knots) / frame.state.view.camera.scale,
                                     most_candidates(frame),
                                     [&](std::size_t span, core::Point point, std::size_t count) {
                                         found.push_back({knots[span], point, count});
                                     });
    std::vector<std::size_t> special = frame.lit.knots;
    if (const auto* hovered = std::get_if<HoveredKnot>(&frame.state.hover)) special.push_back(hovered->index);
    if (frame.state.selection.knot) special.push_back(*frame.state.selection.knot);
    for (const std::size_t index : special)
        if (index < knots.stored().size() && knots.domain().contains(knots.stored()[index]))
            add(knots.stored()[index] == knots.domain().upper && knots.is_periodic() ? knots.domain().lower
                                                                                     : knots.stored()[index]);
    if (!knots.is_periodic()) add(knots.domain().upper);
    std::stable_sort(found.begin(), found.end(),
                     [](const SeenKnot& a, const SeenKnot& b) { return a.value < b.value; });
    found.erase(std::unique(found.begin(), found.end(),
                            [](const SeenKnot& a, const SeenKnot& b) { return a.value == b.value; }),
                found.end());
    return found;
}

ShownKnots shown_knots(const CanvasFrame& frame, const ShownPoints& points) {
    ShownKnots shown;
    // Those of a curve that is made of points are where its points are.
    if (!frame.shows(Overlay::knots) || shown_fit(frame) != nullptr) return shown;
    glm::dvec2 last{-1e9};
    for (const SeenKnot& candidate : seen_knots(frame)) {
        auto mark = mark_of(frame, points, candidate);
        if (!mark && candidate.count > 1) shown.seen += candidate.count;
        if (!mark) continue;
        shown.seen += std::max(candidate.count, static_cast<std::size_t>(mark->multiplicity));
        if (!mark->is_lit && glm::distance(mark->places.front(), last) < frame.pen.px(least_distance)) continue;
        last = mark->places.front();
        shown.knots.push_back(std::move(*mark));
    }
    settle_knots(frame, shown);
    const std::size_t hidden = shown.seen - std::min(shown.seen, knot_count(shown));
    shown.is_thinned = hidden > few_hidden && hidden > shown.seen / 4;
    return shown;
}

std::size_t knot_count(const ShownKnots& shown) {
    std::size_t count = 0;
    for (const CurveKnot& knot : shown.knots) count += static_cast<std::size_t>(knot.multiplicity);
    return count;
}

void draw_curve_knots(CanvasFrame& frame, const ShownKnots& shown) {
    for (const CurveKnot& knot : shown.knots)
        for (const glm::dvec2 place : knot.places)
            frame.pen.symbol(place, {.shape = render::MarkerShape::diamond,
                                     .radius = knot.is_chosen ? knot_radii.front() + 1.5
                                               : knot.is_lit  ? knot_radii.front()
                                                              : shown.radius,
                                     .fill = frame.theme.canvas,
                                     .outline = knot.is_lit ? frame.theme.accent : frame.theme.curve,
                                     .outline_width = knot.is_lit ? 2.0 : 1.5});
}

}  // namespace batten::editor
