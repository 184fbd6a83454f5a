#include "core/refine/split.h"

#include <algorithm>
#include <utility>

#include "core/curve/detail/edit_checks.h"
#include "core/refine/detail/carried_point.h"
#include "core/refine/knot_refinement.h"

namespace batten::core {

namespace {

Result<void> check_inside(double u, Interval range) {
    if (const auto check = check_parameter_finite(u); !check) return check;
    if (range.contains(u)) return {};
    return refuse(
        {.code = CurveErrorCode::parameter_outside_domain, .value = u, .lower = range.lower, .upper = range.upper});
}

// The kind that a clamped part may have.
KnotKind kind_of_part(KnotKind kind) {
    const bool is_equally_spaced = kind == KnotKind::uniform || kind == KnotKind::periodic;
    return is_equally_spaced ? KnotKind::clamped_uniform : kind;
}

Result<Curve> part_of(const Curve& curve, CarriedSpline spline, std::optional<double> a, std::optional<double> b) {
    return settled(curve, part_between(std::move(spline), a, b), kind_of_part(curve.knots().kind()));
}

Result<Curve> part_of_open(const Curve& curve, double a, double b) {
    const Interval domain = curve.domain();
    const auto check = check_inside(a, domain).and_then([&] { return check_inside(b, domain); });
    if (!check) return refuse(check.error());
    if (!(a < b)) return refuse({.code = CurveErrorCode::range_empty, .lower = a, .upper = b});
    if (Interval{a, b} == domain) return curve;
    const auto unless_end = [](double u, double end) { return u == end ? std::nullopt : std::optional(u); };
    return part_of(curve, carried(curve), unless_end(a, domain.lower), unless_end(b, domain.upper));
}

// The knot first comes into the ring, so that both ends of the opened curve are one control point of it.
Result<Curve> opened(const Curve& ring, double u, double later) {
    const int missing = ring.degree() - ring.knots().multiplicity(u);
    const std::vector<double> added(static_cast<std::size_t>(std::max(missing, 0)), u);
    return refine_knots(ring, added).and_then([&](const Curve& refined) {
        return part_of(refined, carried(refined, 1), u, later);
    });
}

Result<Curve> part_of_periodic(const Curve& curve, double a, double b) {
    const Interval domain = curve.domain();
    if (const auto check = check_inside(a, domain); !check) return refuse(check.error());
    // One period later; computed as the repetitions of the knots are, so that equals stay equal.
    const auto later = [&](double u) { return domain.upper + (u - domain.lower); };
    if (const auto check = check_inside(b, {domain.lower, later(a)}); !check) return refuse(check.error());
    double end = b > a ? b : later(b);
    if (end == a) end = later(end);  // the seam, by its two names
    if (end == later(a)) return opened(curve, a, end);
    return part_of(curve, carried(curve, 1), a, end);
}

}  // namespace

Result<Curve> sub_curve(const Curve& curve, double a, double b) {
    return curve.is_periodic() ? part_of_periodic(curve, a, b) : part_of_open(curve, a, b);
}

Result<std::vector<Curve>> split(const Curve& curve, double u) {
    const Interval domain = curve.domain();
    if (const auto check = check_inside(u, domain); !check) return refuse(check.error());
    const auto alone = [](Curve part) { return std::vector<Curve>{std::move(part)}; };
    if (curve.is_periodic()) return part_of_periodic(curve, u, u).map(alone);
    if (u == domain.lower || u == domain.upper)
        return refuse(
            {.code = CurveErrorCode::parameter_at_end, .value = u, .lower = domain.lower, .upper = domain.upper});
    return part_of(curve, carried(curve), std::nullopt, u).and_then([&](const Curve& left) {
        return part_of(curve, carried(curve), u, std::nullopt).map([&](const Curve& right) {
            return std::vector<Curve>{left, right};
        });
    });
}

}  // namespace batten::core
