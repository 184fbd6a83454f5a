#include "core/curve/knot_kinds.h"

#include <utility>

namespace batten::core {

namespace {

// Breakpoint k of `steps` equal steps over the domain. The product before the quotient, so that whole numbers stay
// whole.
double breakpoint(Interval domain, double k, std::size_t steps) {
    const auto count = static_cast<double>(steps);
    return k == count ? domain.upper : domain.lower + k * domain.length() / count;
}

std::vector<double> uniform_values(std::size_t p, std::size_t point_count, Interval domain) {
    std::vector<double> values(point_count + p + 1);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = breakpoint(domain, static_cast<double>(i) - static_cast<double>(p), point_count - p);
    return values;
}

// Ends of multiplicity p+1 and, at the breakpoints between `steps` equal steps, interior knots of one multiplicity.
std::vector<double> clamped_values(std::size_t p, std::size_t steps, std::size_t multiplicity, Interval domain) {
    std::vector<double> values(p + 1, domain.lower);
    for (std::size_t k = 1; k < steps; ++k)
        values.insert(values.end(), multiplicity, breakpoint(domain, static_cast<double>(k), steps));
    values.insert(values.end(), p + 1, domain.upper);
    return values;
}

std::vector<double> period_values(std::size_t point_count, Interval domain) {
    std::vector<double> values(point_count + 1);
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = breakpoint(domain, static_cast<double>(k), point_count);
    return values;
}

bool is_possible(KnotKind kind, std::size_t p, std::size_t point_count) {
    switch (kind) {
        case KnotKind::uniform:
        case KnotKind::clamped_uniform:
        case KnotKind::periodic:
            return true;
        case KnotKind::bezier:
            return point_count == p + 1;
        case KnotKind::piecewise_bezier:
            return point_count % p == 1 % p;
        case KnotKind::custom:
            return false;
    }
    return false;
}

}  // namespace

Result<KnotVector> make_knots(KnotKind kind, int degree, std::size_t point_count, Interval domain) {
    if (const auto check = check_degree(degree); !check) return refuse(check.error());
    const auto p = static_cast<std::size_t>(degree);
    const std::size_t least = kind == KnotKind::periodic ? 2 : p + 1;
    if (point_count < least)
        return refuse({.code = CurveErrorCode::too_few_points,
                       .value = static_cast<double>(point_count),
                       .lower = static_cast<double>(least)});
    if (!is_possible(kind, p, point_count)) return refuse({.code = CurveErrorCode::kind_not_possible});
    if (kind == KnotKind::periodic) return KnotVector::make_periodic(degree, period_values(point_count, domain), kind);
    if (kind == KnotKind::uniform) return KnotVector::make(degree, uniform_values(p, point_count, domain), kind);
    const bool is_piecewise = kind == KnotKind::piecewise_bezier;
    const std::size_t steps = is_piecewise ? (point_count - 1) / p : point_count - p;
    return KnotVector::make(degree, clamped_values(p, steps, is_piecewise ? p : 1, domain), kind);
}

}  // namespace batten::core
