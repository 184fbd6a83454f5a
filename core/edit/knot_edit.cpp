#include "core/edit/knot_edit.h"

#include <algorithm>
#include <cmath>

#include "core/curve/detail/edit_checks.h"
#include "core/curve/knot_analysis.h"
#include "core/curve/knot_kinds.h"

namespace batten::core {

namespace {

Result<Curve> with_knots(const Curve& curve, std::vector<double> knots, Tears tears = Tears::refuse) {
    CurveDefinition definition = curve.definition();
    definition.knots = std::move(knots);
    definition.kind = KnotKind::custom;
    if (tears == Tears::allow) definition.tears = tears;
    return Curve::make(std::move(definition));
}

// The control point q in [first, last] whose Greville abscissa is nearest to knot r of values(), both unrolled.
std::size_t point_carried_most(const KnotVector& knots, std::size_t r, std::size_t first, std::size_t last) {
    const auto p = static_cast<std::ptrdiff_t>(knots.degree());
    const auto distance = [&](std::size_t q) {
        const auto begin = knots.values().begin() + static_cast<std::ptrdiff_t>(q) + 1;
        double sum = 0.0;
        for (auto knot = begin; knot != begin + p; ++knot) sum += *knot - knots[r];
        return std::abs(sum);
    };
    std::size_t nearest = first;
    for (std::size_t q = first + 1; q <= last; ++q)
        if (distance(q) < distance(nearest)) nearest = q;
    return nearest;
}

std::vector<double> without_knot(const KnotVector& knots, std::size_t index) {
    const auto stored = knots.stored();
    std::vector<double> rest(stored.begin(), stored.end());
    const double period = rest.back() - rest.front();
    const bool is_seam = knots.is_periodic() && (index == 0 || index + 1 == rest.size());
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(is_seam ? 0 : index));
    if (is_seam) rest.back() = rest.front() + period;
    return rest;
}

}  // namespace

Result<Curve> set_knot(const Curve& curve, std::size_t index, double u, Tears tears) {
    const auto check = check_knot_index(curve, index).and_then([&] { return check_parameter_finite(u); });
    if (!check) return tl::unexpected(check.error());
    const auto stored = curve.knots().stored();
    if (u == stored[index]) return curve;
    std::vector<double> knots(stored.begin(), stored.end());
    const auto run = std::equal_range(knots.begin(), knots.end(), knots[index]);
    *(u > knots[index] ? run.second - 1 : run.first) = u;
    return with_knots(curve, std::move(knots), tears);
}

Result<Curve> delete_knot(const Curve& curve, std::size_t index) {
    if (auto check = check_knot_index(curve, index); !check) return tl::unexpected(check.error());
    const KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(knots.degree());
    const std::size_t count = knots.control_point_count();
    const std::size_t least = knots.is_periodic() ? 2 : p + 1;
    const CurveError not_removable{.code = CurveErrorCode::knot_not_removable, .index = index};
    if (count <= least) return tl::unexpected(not_removable);

    const bool is_at_period_end = knots.is_periodic() && index == count;
    const std::size_t r = knots.stored_offset() + (is_at_period_end ? 0 : index);
    const std::size_t ends_kept = is_clamped(knots) ? 1 : 0;
    const std::size_t first = std::clamp(r < p + 1 ? 0 : r - p - 1, ends_kept, count - 1 - ends_kept);
    const std::size_t last = std::clamp(r, first, count - 1 - ends_kept);
    const auto q = static_cast<std::ptrdiff_t>(point_carried_most(knots, r, first, last));

    CurveDefinition definition = curve.definition();
    definition.knots = without_knot(knots, index);
    definition.points.erase(definition.points.begin() + q);
    definition.weights.erase(definition.weights.begin() + q);
    return Curve::make(std::move(definition)).map_error([&](const CurveError&) { return not_removable; });
}

Result<Curve> set_knot_kind(const Curve& curve, KnotKind kind) {
    CurveDefinition definition = curve.definition();
    if (kind == KnotKind::custom) return with_knots(curve, std::move(definition.knots));
    return make_knots(kind, curve.degree(), definition.points.size(), curve.domain()).and_then([&](KnotVector knots) {
        return Curve::make(std::move(knots), std::move(definition.points), std::move(definition.weights));
    });
}

Result<Curve> make_uniform(const Curve& curve) {
    if (curve.is_periodic()) return set_knot_kind(curve, KnotKind::periodic);
    return set_knot_kind(curve, is_clamped(curve.knots()) ? KnotKind::clamped_uniform : KnotKind::uniform);
}

Result<Curve> set_knots(const Curve& curve, std::vector<double> knots, Tears tears) {
    return with_knots(curve, std::move(knots), tears);
}

Result<Curve> set_periodic(const Curve& curve, bool periodic) {
    if (periodic == curve.is_periodic()) return curve;
    return set_knot_kind(curve, periodic ? KnotKind::periodic : KnotKind::clamped_uniform);
}

}  // namespace batten::core
