#include "core/curve/knot_kinds.h"

#include <algorithm>

namespace batten::core {

namespace {

// Breakpoint k of `steps` equal steps over the domain. The product before the quotient, so that whole numbers stay
// whole.
double breakpoint(Interval domain, double k, std::size_t steps) {
    const auto count = static_cast<double>(steps);
    return k == count ? domain.upper : domain.lower + k * domain.length() / count;
}

// Breakpoints between equal steps; what is outside of the domain goes on in the same steps, or stays at a clamped end.
std::vector<double> even_values(std::size_t p, std::size_t point_count, Interval domain, ClampedEnds clamped) {
    const std::size_t steps = point_count - p;
    std::vector<double> values(point_count + p + 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double k = static_cast<double>(i) - static_cast<double>(p);
        const double first = clamped.start ? std::max(k, 0.0) : k;
        values[i] = breakpoint(domain, clamped.end ? std::min(first, static_cast<double>(steps)) : first, steps);
    }
    return values;
}

// Ends of multiplicity p+1 and, at the breakpoints between equal steps, interior knots of multiplicity p.
std::vector<double> piecewise_values(std::size_t p, std::size_t point_count, Interval domain) {
    const std::size_t steps = (point_count - 1) / p;
    std::vector<double> values(p + 1, domain.lower);
    for (std::size_t k = 1; k < steps; ++k)
        values.insert(values.end(), p, breakpoint(domain, static_cast<double>(k), steps));
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

Result<void> check_count(int degree, std::size_t point_count, std::size_t least) {
    if (auto check = check_degree(degree); !check) return check;
    if (point_count >= least) return {};
    return refuse({.code = CurveErrorCode::too_few_points,
                   .value = static_cast<double>(point_count),
                   .lower = static_cast<double>(least)});
}

}  // namespace

Result<KnotVector> make_knots(KnotKind kind, int degree, std::size_t point_count, Interval domain) {
    const auto p = static_cast<std::size_t>(degree);
    if (auto check = check_count(degree, point_count, kind == KnotKind::periodic ? 2 : p + 1); !check)
        return refuse(check.error());
    if (!is_possible(kind, p, point_count)) return refuse({.code = CurveErrorCode::kind_not_possible});
    if (kind == KnotKind::periodic) return KnotVector::make_periodic(degree, period_values(point_count, domain), kind);
    if (kind == KnotKind::piecewise_bezier)
        return KnotVector::make(degree, piecewise_values(p, point_count, domain), kind);
    const bool is_clamped = kind != KnotKind::uniform;
    return KnotVector::make(degree, even_values(p, point_count, domain, {is_clamped, is_clamped}), kind);
}

Result<KnotVector> make_even_knots(int degree, std::size_t point_count, Interval domain, ClampedEnds clamped) {
    const auto p = static_cast<std::size_t>(degree);
    if (auto check = check_count(degree, point_count, p + 1); !check) return refuse(check.error());
    return KnotVector::make(degree, even_values(p, point_count, domain, clamped));
}

}  // namespace batten::core
