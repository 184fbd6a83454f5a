#include "core/curve/knot_analysis.h"

#include <cmath>

namespace batten::core {

namespace {

std::size_t degree_of(const KnotVector& knots) {
    return static_cast<std::size_t>(knots.degree());
}

// The different values within the domain, both ends included.
std::vector<double> breakpoints(const KnotVector& knots) {
    const auto domain = knots.values().subspan(degree_of(knots), knots.size() - 2 * degree_of(knots));
    std::vector<double> values(domain.begin(), domain.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

// Whether ascending values are spaced equally, but for a few roundings of values of this size.
bool are_equally_spaced(std::span<const double> values) {
    const double first = values.front();
    const double length = values.back() - first;
    const auto steps = static_cast<double>(values.size() - 1);
    const double size = std::max(std::abs(first), std::abs(values.back()));
    const double tolerance = 4 * std::numeric_limits<double>::epsilon() * size;
    for (std::size_t k = 0; k < values.size(); ++k)
        if (std::abs(first + static_cast<double>(k) * length / steps - values[k]) > tolerance) return false;
    return true;
}

// Counting comes first: it settles most cases at once.
bool have_interior_multiplicity(const KnotVector& knots, int multiplicity) {
    const std::size_t interior = knots.size() - 2 * degree_of(knots) - 2;
    const std::size_t joints = segment_count(knots) - 1;
    if (!knots.is_periodic() && interior != joints * static_cast<std::size_t>(multiplicity) && is_clamped(knots))
        return false;
    const auto distinct = distinct_knots(knots);
    return std::all_of(distinct.begin(), distinct.end(), [&](const DistinctKnot& knot) {
        return !knot.is_interior || knot.multiplicity == multiplicity;
    });
}

bool are_all_simple(const KnotVector& knots) {
    const auto values = knots.values();
    return std::adjacent_find(values.begin(), values.end()) == values.end();
}

}  // namespace

std::vector<DistinctKnot> distinct_knots(const KnotVector& knots) {
    const auto stored = knots.stored();
    const Interval domain = knots.domain();
    std::vector<DistinctKnot> distinct;
    for (std::size_t i = 0; i < stored.size(); ++i) {
        const double u = stored[i];
        if (i > 0 && u == stored[i - 1]) continue;
        if (knots.is_periodic() && u == domain.upper) break;
        const int multiplicity = knots.multiplicity(u);
        distinct.push_back({.value = u,
                            .first = knots.stored_offset() + i,
                            .multiplicity = multiplicity,
                            .continuity = knots.degree() - multiplicity,
                            .in_domain = domain.contains(u),
                            .is_interior = knots.is_periodic() || (domain.lower < u && u < domain.upper)});
    }
    return distinct;
}

std::size_t segment_count(const KnotVector& knots) {
    return breakpoints(knots).size() - 1;
}

bool is_clamped(const KnotVector& knots) {
    // More than counting: a run of p+1 knots may also begin one knot after the first, and the first point is then no
    // end.
    const auto [lower, upper] = knots.domain();
    return !knots.is_periodic() && knots.values().front() == lower && knots.values().back() == upper;
}

bool is_uniform(const KnotVector& knots) {
    return are_equally_spaced(breakpoints(knots)) && have_interior_multiplicity(knots, 1);
}

std::optional<int> least_continuity(const KnotVector& knots) {
    std::optional<int> least;
    for (const DistinctKnot& knot : distinct_knots(knots))
        if (knot.is_interior && (!least || knot.continuity < *least)) least = knot.continuity;
    return least;
}

std::vector<double> greville_abscissae(const KnotVector& knots) {
    const std::size_t p = degree_of(knots);
    std::vector<double> abscissae(knots.control_point_count());
    for (std::size_t i = 0; i < abscissae.size(); ++i) {
        // Summed as offsets from the first knot, so that the average of equal knots is that knot and nothing is lost
        // where the knots are close together and far from zero.
        double offset = 0.0;
        for (std::size_t k = 2; k <= p; ++k) offset += knots[i + k] - knots[i + 1];
        const double average = knots[i + 1] + offset / static_cast<double>(p);
        abscissae[i] = knots.is_periodic() ? knots.into_domain(average) : average;
    }
    return abscissae;
}

bool is_of_kind(const KnotVector& knots, KnotKind kind) {
    switch (kind) {
        case KnotKind::uniform:
            return !knots.is_periodic() && are_all_simple(knots) && are_equally_spaced(knots.values());
        case KnotKind::clamped_uniform:
            return is_clamped(knots) && is_uniform(knots);
        case KnotKind::bezier:
            return is_clamped(knots) && segment_count(knots) == 1;
        case KnotKind::piecewise_bezier:
            return is_clamped(knots) && have_interior_multiplicity(knots, knots.degree());
        case KnotKind::periodic:
            return knots.is_periodic() && is_uniform(knots);
        case KnotKind::custom:
            return true;
    }
    return false;
}

KnotKind classify(const KnotVector& knots) {
    for (const KnotKind kind : {KnotKind::bezier, KnotKind::clamped_uniform, KnotKind::piecewise_bezier,
                                KnotKind::uniform, KnotKind::periodic})
        if (is_of_kind(knots, kind)) return kind;
    return KnotKind::custom;
}

KnotKind kind_by_values(const KnotVector& knots) {
    return knots.kind() == KnotKind::custom ? classify(knots) : knots.kind();
}

}  // namespace batten::core
