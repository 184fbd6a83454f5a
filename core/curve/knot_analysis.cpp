#include "core/curve/knot_analysis.h"

#include <cmath>

namespace batten::core {

namespace {

std::size_t degree_of(const KnotVector& knots) {
    return static_cast<std::size_t>(knots.degree());
}

// The knots of the domain; of the runs at its ends the innermost one alone.
std::span<const double> interior_with_ends(const KnotVector& knots) {
    const auto [lower, upper] = knots.domain();
    auto domain = knots.values().subspan(degree_of(knots), knots.size() - 2 * degree_of(knots));
    while (domain[1] == lower) domain = domain.subspan(1);
    while (domain[domain.size() - 2] == upper) domain = domain.first(domain.size() - 1);
    return domain;
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

bool are_all_different(std::span<const double> ascending) {
    return std::adjacent_find(ascending.begin(), ascending.end()) == ascending.end();
}

// Of an open vector.
bool has_interior_multiplicity(const KnotVector& knots, std::size_t multiplicity) {
    const auto around = interior_with_ends(knots);
    const auto interior = around.subspan(1, around.size() - 2);
    if (interior.size() % multiplicity != 0) return false;
    for (std::size_t first = 0; first < interior.size(); first += multiplicity) {
        const double last = interior[first + multiplicity - 1];
        if (interior[first] != last || around[first + multiplicity + 1] == last) return false;
    }
    return true;
}

// Calls `visit` with the index in stored() of the first knot of every run; the upper end of a period is its beginning.
template <class Visit>
void visit_runs(const KnotVector& knots, const Visit& visit) {
    const auto stored = knots.stored();
    for (std::size_t i = 0; i < stored.size(); ++i) {
        if (knots.is_periodic() && stored[i] == knots.domain().upper) return;
        if (i == 0 || stored[i] != stored[i - 1]) visit(i);
    }
}

}  // namespace

DistinctKnot distinct_knot(const KnotVector& knots, std::size_t first) {
    const auto stored = knots.stored();
    const Interval domain = knots.domain();
    const double u = stored[first];
    std::size_t end = first;
    while (end < stored.size() && stored[end] == u) ++end;
    const bool is_seam = knots.is_periodic() && u == domain.lower;
    const int multiplicity = is_seam ? knots.multiplicity(u) : static_cast<int>(end - first);
    return {.value = u,
            .first = knots.stored_offset() + first,
            .multiplicity = multiplicity,
            .continuity = knots.degree() - multiplicity,
            .in_domain = domain.contains(u),
            .is_interior = knots.is_periodic() || (domain.lower < u && u < domain.upper)};
}

std::vector<DistinctKnot> distinct_knots(const KnotVector& knots) {
    std::vector<DistinctKnot> distinct;
    distinct.reserve(knots.stored().size());
    visit_distinct_knots(knots, [&](const DistinctKnot& knot) { distinct.push_back(knot); });
    return distinct;
}

void visit_distinct_knots(const KnotVector& knots, const std::function<void(const DistinctKnot&)>& use) {
    visit_runs(knots, [&](std::size_t first) { use(distinct_knot(knots, first)); });
}

std::size_t segment_count(const KnotVector& knots) {
    const auto around = interior_with_ends(knots);
    std::size_t count = 0;
    for (std::size_t i = 1; i < around.size(); ++i) count += around[i] != around[i - 1] ? 1U : 0U;
    return count;
}

bool is_clamped(const KnotVector& knots) {
    // More than counting: a run of p+1 knots may also begin one knot after the first, and the first point is then no
    // end.
    const auto [lower, upper] = knots.domain();
    return !knots.is_periodic() && knots.values().front() == lower && knots.values().back() == upper;
}

bool is_uniform(const KnotVector& knots) {
    const auto around = interior_with_ends(knots);
    const bool is_seam_simple = around.size() == knots.size() - 2 * degree_of(knots);
    return (is_seam_simple || !knots.is_periodic()) && are_equally_spaced(around) && are_all_different(around);
}

std::optional<int> least_continuity(const KnotVector& knots) {
    std::optional<int> least;
    visit_runs(knots, [&](std::size_t first) {
        const DistinctKnot knot = distinct_knot(knots, first);
        if (knot.is_interior && (!least || knot.continuity < *least)) least = knot.continuity;
    });
    return least;
}

double greville_abscissa(const KnotVector& knots, std::size_t i) {
    const std::size_t p = degree_of(knots);
    // Summed as offsets from the first knot, so that the average of equal knots is that knot and nothing is lost where
    // the knots are close together and far from zero.
    double offset = 0.0;
    for (std::size_t k = 2; k <= p; ++k) offset += knots[i + k] - knots[i + 1];
    return knots[i + 1] + offset / static_cast<double>(p);
}

std::vector<double> greville_abscissae(const KnotVector& knots) {
    std::vector<double> abscissae(knots.control_point_count());
    for (std::size_t i = 0; i < abscissae.size(); ++i) {
        const double average = greville_abscissa(knots, i);
        abscissae[i] = knots.is_periodic() ? knots.into_domain(average) : average;
    }
    return abscissae;
}

bool is_of_kind(const KnotVector& knots, KnotKind kind) {
    switch (kind) {
        case KnotKind::uniform:
            return !knots.is_periodic() && are_equally_spaced(knots.values()) && are_all_different(knots.values());
        case KnotKind::clamped_uniform:
            return is_clamped(knots) && is_uniform(knots);
        case KnotKind::bezier:
            return is_clamped(knots) && interior_with_ends(knots).size() == 2;
        case KnotKind::piecewise_bezier:
            return is_clamped(knots) && has_interior_multiplicity(knots, degree_of(knots));
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
