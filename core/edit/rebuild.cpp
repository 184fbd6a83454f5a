#include "core/edit/rebuild.h"

#include <algorithm>

#include "core/curve/knot_analysis.h"
#include "core/curve/knot_kinds.h"
#include "core/evaluate/detail/spline_system.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/arc_length.h"
#include "core/measure/deviation.h"

namespace batten::core {

namespace {

// Between so many places at equal shares of the length the speeds are taken for even, which makes the bound larger than
// the distance by less than a millionth of the length on all but wild curves.
constexpr std::size_t least_parts = 1000;

// So many places that no span of the old curve and none of the new one is passed over.
std::size_t site_count(const Curve& curve, const KnotVector& knots) {
    const auto at_least = [](std::size_t knot_count, int degree) {
        return 2 * knot_count * (static_cast<std::size_t>(degree) + 1);
    };
    return std::max(at_least(curve.knots().size(), curve.degree()), at_least(knots.size(), knots.degree()));
}

// The middle of part `k` of `count` equal parts of [0, 1].
double middle_of_part(std::size_t k, std::size_t count) {
    return (static_cast<double>(k) + 0.5) / static_cast<double>(count);
}

Point point_at_share(const Curve& curve, const ArcLengthTable& lengths, double share) {
    return point_at(curve, lengths.parameter_at(share * lengths.total().value));
}

EndPoints ends_of(const Curve& curve, std::size_t count) {
    if (curve.is_periodic()) return {};
    const bool is_clamped = core::is_clamped(curve.knots());
    const Point first = is_clamped ? curve.control_points().front() : point_at(curve, curve.domain().lower);
    const Point last = is_clamped ? curve.control_points().back() : point_at(curve, curve.domain().upper);
    return {.known = {{0, first}, {count - 1, last}}};
}

// A bound of the distance where both are run through at an even speed.
double largest_distance(const Curve& curve, const Curve& rebuilt, const ArcLengthTable& lengths, std::size_t parts) {
    const Interval domain = curve.domain();
    std::vector<MatchedParameters> matches{{domain.lower, domain.lower}};
    for (std::size_t k = 1; k < parts; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(parts);
        matches.push_back(
            {lengths.parameter_at(share * lengths.total().value), domain.lower + share * domain.length()});
    }
    matches.push_back({domain.upper, domain.upper});
    return largest_deviation(curve, rebuilt, matches);
}

}  // namespace

Result<Approximation> rebuild(const Curve& curve, std::size_t count, int degree, const Progress& progress) {
    const KnotKind kind = curve.is_periodic() ? KnotKind::periodic : KnotKind::clamped_uniform;
    const Interval domain = curve.domain();
    auto knots = make_knots(kind, degree, count, domain);
    if (!knots) return refuse(knots.error());
    const ArcLengthTable lengths(curve);
    if (!is_sharp(lengths.total())) return refuse({.code = CurveErrorCode::not_computable});
    if (lengths.total().value == 0.0)
        return refuse({.code = CurveErrorCode::curve_stands_still, .value = domain.lower});
    const EndPoints ends = ends_of(curve, count);
    SplineSystem system(*knots, curve.control_points().front(), ends);
    const std::size_t sites = site_count(curve, *knots);
    for (std::size_t k = 0; k < sites; ++k) {
        const double share = middle_of_part(k, sites);
        system.require_point(domain.lower + share * domain.length(), point_at_share(curve, lengths, share));
    }
    auto points = system.solve(progress);
    if (!points) return refuse({.code = CurveErrorCode::equations_singular});
    for (const KnownPoint& end : ends.known) (*points)[end.index] = end.point;
    auto rebuilt = Curve::make(*std::move(knots), *std::move(points), {});
    if (!rebuilt) return refuse(rebuilt.error());
    const double error = largest_distance(curve, *rebuilt, lengths, std::max(sites, least_parts));
    return Approximation{*std::move(rebuilt), error};
}

}  // namespace batten::core
