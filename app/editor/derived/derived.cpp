#include "app/editor/derived/derived.h"

#include <algorithm>
#include <cmath>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/polygon_distance.h"
#include "core/refine/knot_insertion.h"

namespace batten::editor {

namespace {

KnotFacts facts_of_knots(const core::KnotVector& knots) {
    KnotFacts facts;
    facts.segment_count = core::segment_count(knots);
    facts.least_continuity = core::least_continuity(knots);
    const auto stored = knots.stored();
    for (std::size_t i = 0; i < stored.size(); ++i) {
        if (knots.is_periodic() && stored[i] == knots.domain().upper) break;
        if (i == 0 || stored[i] != stored[i - 1]) facts.runs.push_back(static_cast<std::uint32_t>(i));
    }
    facts.kind = core::kind_by_values(knots);
    facts.is_bezier = facts.segment_count == 1 && core::is_clamped(knots);
    return facts;
}

CurveFacts facts_of_curve(const core::Curve& curve) {
    const core::Box box = core::control_box(curve);
    return {.control_box = box, .size = std::max(box.size().x, box.size().y)};
}

WeightFacts facts_of_weights(const core::Curve& curve) {
    const auto weights = curve.weights();
    return {.column = weight_column(curve),
            .lightest = curve.is_rational() ? std::ranges::min(weights) : weights.front(),
            .heaviest = curve.is_rational() ? std::ranges::max(weights) : weights.front()};
}

double large_curvature_of(const core::Curve& curve) {
    const core::KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t spans = knots.size() - 2 * p - 1;
    const int samples = std::clamp(256 / static_cast<int>(spans), 3, 24);
    constexpr std::size_t most_measured_spans = 1000;
    const std::size_t stride = spans / most_measured_spans + 1;
    std::vector<double> values;
    for (std::size_t s = p; s + p + 1 < knots.size(); s += stride)
        for (int k = 0; k < samples && knots[s] < knots[s + 1]; ++k) {
            const double u = knots[s] + (k + 0.5) / samples * (knots[s + 1] - knots[s]);
            if (const auto value = core::curvature_at(curve, u)) values.push_back(std::abs(*value));
        }
    if (values.empty()) return 0.0;
    const auto rank = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 9 / 10);
    std::nth_element(values.begin(), rank, values.end());
    return *rank;
}

std::vector<PolygonRound> rounds_of(const core::Curve& curve) {
    constexpr std::size_t most_points = 1000;
    constexpr std::size_t most_refined_points = 100;
    constexpr std::size_t most_rounds = 3;
    std::vector<PolygonRound> rounds;
    if (curve.control_points().size() > most_points) return rounds;
    rounds.push_back({std::make_shared<const core::Curve>(curve), core::polygon_distance(curve)});
    while (rounds.size() <= most_rounds) {
        const core::Curve& last = *rounds.back().curve;
        if (last.control_points().size() + core::segment_count(last.knots()) > most_refined_points) break;
        auto refined = core::insert_midpoint_knots(last);
        if (!refined || refined->control_points().size() == last.control_points().size()) break;
        const double distance = core::polygon_distance(*refined);
        rounds.push_back({std::make_shared<const core::Curve>(*std::move(refined)), distance});
    }
    return rounds;
}

}  // namespace

bool share_arrays(const core::KnotVector& a, const core::KnotVector& b) {
    return a.values().data() == b.values().data() && a.degree() == b.degree() && a.is_periodic() == b.is_periodic() &&
           a.kind() == b.kind();
}

bool share_arrays(const core::Curve& a, const core::Curve& b) {
    return a.control_points().data() == b.control_points().data() && a.weights().data() == b.weights().data() &&
           share_arrays(a.knots(), b.knots());
}

bool share_weights(const core::Curve& a, const core::Curve& b) {
    return a.weights().data() == b.weights().data() && a.is_rational() == b.is_rational();
}

bool share_arrays(const MappedCurve& a, const MappedCurve& b) {
    return a.map == b.map && share_arrays(a.curve, b.curve);
}

std::shared_ptr<const std::vector<PolygonRound>> Derived::polygon_rounds(const core::Curve& curve) const {
    return polygon_rounds_.of(curve, rounds_of);
}

std::shared_ptr<const KnotFacts> Derived::of(const core::KnotVector& knots) const {
    return of_knots_.of(knots, facts_of_knots);
}

std::shared_ptr<const CurveFacts> Derived::of(const core::Curve& curve) const {
    return of_curves_.of(curve, facts_of_curve);
}

std::shared_ptr<const WeightFacts> Derived::weights_of(const core::Curve& curve) const {
    return of_weights_.of(curve, facts_of_weights);
}

std::shared_ptr<const PlotBasis> Derived::plot_basis(const core::KnotVector& knots) const {
    return plot_bases_.of(knots, [](const core::KnotVector& of) { return PlotBasis(of); });
}

double Derived::large_curvature(const core::Curve& curve) const {
    return *large_curvatures_.of(curve, large_curvature_of);
}

std::shared_ptr<const KnotAnswers> Derived::answers_about(const core::KnotVector& knots) const {
    return answers_.of(knots, editor::answers_about);
}

std::shared_ptr<const MapCheck> Derived::map_check(const MappedCurve& mapped) const {
    return map_checks_.of(mapped, check_map);
}

std::shared_ptr<const core::NearParts> Derived::near_parts(const std::shared_ptr<const core::Curve>& curve) const {
    return near_parts_.of(curve, [](const core::Curve& of) { return core::NearParts(of); });
}

}  // namespace batten::editor
