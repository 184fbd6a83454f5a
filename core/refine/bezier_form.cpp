#include "core/refine/bezier_form.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/curve/detail/edit_checks.h"
#include "core/curve/knot_analysis.h"
#include "core/refine/clamping.h"
#include "core/refine/degree.h"
#include "core/refine/detail/carried_point.h"
#include "core/refine/knot_refinement.h"
#include "core/refine/knot_removal.h"
#include "core/refine/reparametrize.h"

namespace batten::core {

namespace {

std::vector<double> knots_missing(const Curve& curve) {
    std::vector<double> missing;
    for (const DistinctKnot& knot : distinct_knots(curve.knots()))
        if (knot.is_interior && knot.multiplicity < curve.degree())
            missing.insert(missing.end(), static_cast<std::size_t>(curve.degree() - knot.multiplicity), knot.value);
    return missing;
}

Result<Curve> with_bezier_kind(const Curve& curve) {
    CurveDefinition definition = curve.definition();
    definition.kind = segment_count(curve.knots()) == 1 ? KnotKind::bezier : KnotKind::piecewise_bezier;
    return Curve::make(std::move(definition));
}

Result<Curve> curve_over_span(const Curve& curve, std::size_t s) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t n = curve.control_points().size();
    CurveDefinition piece{
        .degree = curve.degree(), .knots = std::vector(p + 1, curve.knots()[s]), .kind = KnotKind::bezier};
    piece.knots.insert(piece.knots.end(), p + 1, curve.knots()[s + 1]);
    for (std::size_t i = s - p; i <= s; ++i) {
        piece.points.push_back(curve.control_points()[i % n]);
        piece.weights.push_back(curve.weights()[i % n]);
    }
    return Curve::make(std::move(piece));
}

// The piece as it is joined: clamped, of this degree, with its domain beginning at `lower` if that is given.
Result<Curve> prepared(const Curve& piece, int degree, std::optional<double> lower) {
    auto curve = clamp_ends(piece);
    if (curve && degree > curve->degree()) curve = elevate_degree(*curve, degree - curve->degree());
    if (curve && lower && *lower != curve->domain().lower) curve = shift_domain(*curve, *lower);
    return curve;
}

}  // namespace

Result<Curve> to_bezier(const Curve& curve) {
    return refine_knots(curve, knots_missing(curve))
        .and_then(
            [](const Curve& refined) -> Result<Curve> { return refined.is_periodic() ? refined : clamp_ends(refined); })
        .and_then(with_bezier_kind);
}

Result<std::vector<Curve>> bezier_curves(const Curve& curve) {
    const auto whole = to_bezier(curve);
    if (!whole) return refuse(whole.error());
    const KnotVector& knots = whole->knots();
    const auto p = static_cast<std::size_t>(knots.degree());
    std::vector<Curve> curves;
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s) {
        if (knots[s] == knots[s + 1]) continue;
        auto piece = curve_over_span(*whole, s);
        if (!piece) return refuse(piece.error());
        curves.push_back(*std::move(piece));
    }
    return curves;
}

CurveDefinition concatenated(CurveDefinition first, const CurveDefinition& second) {
    const auto p = static_cast<std::ptrdiff_t>(first.degree);
    assert(first.degree == second.degree);
    assert(first.knots.back() == second.knots.front() && *(first.knots.end() - 1 - p) == *(second.knots.begin() + p));
    assert(first.weights.size() == first.points.size() && second.weights.size() == second.points.size());
    const double before = first.weights.back();
    const double after = second.weights.front();
    first.knots.pop_back();
    first.knots.insert(first.knots.end(), second.knots.begin() + p + 1, second.knots.end());
    first.points.insert(first.points.end(), second.points.begin() + 1, second.points.end());
    for (std::size_t i = 1; i < second.weights.size(); ++i)
        first.weights.push_back(before == after ? second.weights[i] : second.weights[i] * (before / after));
    if (second.tears == Tears::allow) first.tears = Tears::allow;
    if (first.kind == KnotKind::bezier) first.kind = KnotKind::piecewise_bezier;
    if (first.kind != second.kind && second.kind != KnotKind::bezier) first.kind = KnotKind::custom;
    return first;
}

Result<Approximation> join_pieces(std::span<const Curve> pieces, double tolerance) {
    assert(!pieces.empty());
    if (const auto check = check_tolerance(tolerance); !check) return refuse(check.error());
    const int degree = std::max_element(pieces.begin(), pieces.end(), [](const Curve& a, const Curve& b) {
                           return a.degree() < b.degree();
                       })->degree();
    std::optional<CurveDefinition> whole;
    std::vector<double> joints;
    double largest_gap = 0.0;
    for (const Curve& piece : pieces) {
        const std::optional<double> begin = whole ? std::optional(whole->knots.back()) : std::nullopt;
        const auto next = prepared(piece, degree, begin);
        if (!next) return refuse(next.error());
        if (!whole) {
            whole = next->definition();
            continue;
        }
        const double gap = robust_length(next->control_points().front() - whole->points.back());
        if (!(gap <= tolerance))
            return refuse_computed({.code = CurveErrorCode::ends_apart, .value = gap, .upper = tolerance});
        largest_gap = std::max(largest_gap, gap);
        joints.push_back(*begin);
        whole = concatenated(*std::move(whole), next->definition());
    }
    const auto joined = Curve::make(*std::move(whole));
    if (!joined) return refuse(joined.error());
    return remove_knots_among(*joined, joints, tolerance).map([&](const KnotRemoval& removal) {
        return Approximation{removal.curve, largest_gap + removal.error};
    });
}

}  // namespace batten::core
