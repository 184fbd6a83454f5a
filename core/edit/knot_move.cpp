#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/curve/detail/edit_checks.h"
#include "core/edit/knot_edit.h"

namespace batten::core {

namespace {

// What cannot be joined is kept apart by this part of the domain, so that both remain visible and can be taken hold of.
constexpr double closest_approach = 1.0 / 200.0;
// Among dense knots, by this part of the way from the knot before to the one after.
constexpr double closest_among_dense = 1.0 / 10.0;

// The stored knots with one of them on the way to a larger value. A move to a smaller value is the same thing in the
// mirror (all knots reversed and negated), which is exact.
struct KnotRow {
    int degree = 0;
    bool is_periodic = false;
    bool is_torn = false;
    bool may_join = false;
    bool may_tear = false;  // here
    std::vector<double> knots;
    std::size_t moved = 0;
    double target = 0.0;

    double period() const { return knots.back() - knots.front(); }

    // Both ends of a period are one knot.
    bool is_seam() const { return is_periodic && (moved == 0 || moved + 1 == knots.size()); }

    Interval domain() const {
        const auto p = is_periodic ? 0 : static_cast<std::size_t>(degree);
        return {knots[p], knots[knots.size() - 1 - p]};
    }

    double least_distance() const { return closest_approach * domain().length(); }
};

void mirror(KnotRow& row) {
    std::reverse(row.knots.begin(), row.knots.end());
    for (double& knot : row.knots) knot = -knot;
    row.moved = row.knots.size() - 1 - row.moved;
    row.target = -row.target;
}

// Of equal knots the last goes; across the seam the stack goes on at the other end of the period.
void take_last_of_stack(KnotRow& row) {
    if (row.is_periodic && row.knots[row.moved] == row.knots.back()) {
        row.target = row.knots.front() + (row.target - row.knots.back());
        row.moved = 0;
    }
    while (row.moved + 1 < row.knots.size() && row.knots[row.moved + 1] == row.knots[row.moved]) ++row.moved;
}

// Puts the moved knot to `u`. The seam takes the other end of the period along.
std::vector<double> with_moved_at(const KnotRow& row, double u) {
    std::vector<double> knots = row.knots;
    if (row.is_seam()) {
        knots.front() = u;
        knots.back() = u + row.period();
    }
    knots[row.moved] = u;
    return knots;
}

// Whether the moved knot can join the next stack: inside, a multiplicity above p comes about only where it is allowed.
bool can_join(const KnotRow& row, double next) {
    if (!row.may_join) return false;
    const Tears tears = row.is_torn || row.may_tear ? Tears::allow : Tears::refuse;
    const auto joined = row.is_periodic
                            ? KnotVector::make_periodic(row.degree, with_moved_at(row, next))
                            : KnotVector::make(row.degree, with_moved_at(row, next), KnotKind::custom, tears);
    if (!joined) return false;
    if (row.may_tear) return true;
    const Interval domain = joined->domain();
    const bool is_end = !row.is_periodic && (next == domain.lower || next == domain.upper);
    return is_end || joined->multiplicity(next) <= row.degree;
}

// How far the moved knot comes that must stay below `next`: not at all where it is as near already.
double limit_below(const KnotRow& row, double next) {
    const double knot = row.knots[row.moved];
    const double before = row.moved == 0 ? knot : row.knots[row.moved - 1];
    const double limit = next - std::min(row.least_distance(), closest_among_dense * (next - before));
    return limit < next ? std::max(knot, limit) : knot;
}

std::vector<double> stopped(const KnotRow& row) {
    if (row.moved + 1 == row.knots.size()) return with_moved_at(row, row.target);
    const double next = row.knots[row.moved + 1];
    return with_moved_at(row, std::min(row.target, can_join(row, next) ? next : limit_below(row, next)));
}

// The first knot that is not pushed: the next end of the domain, which only a knot at or outside of it moves. Past the
// end when there is none, as for the seam, which takes both ends along.
std::size_t first_unpushed(const KnotRow& row) {
    const Interval domain = row.domain();
    const double knot = row.knots[row.moved];
    if (row.is_seam() || knot >= domain.upper) return row.knots.size();
    const double wall = knot < domain.lower ? domain.lower : domain.upper;
    return static_cast<std::size_t>(std::lower_bound(row.knots.begin(), row.knots.end(), wall) - row.knots.begin());
}

std::vector<double> pushed(const KnotRow& row) {
    const std::size_t moved = row.moved;
    const std::size_t wall = first_unpushed(row);
    const auto kept_distance = [&](std::size_t k) {
        return std::min(row.knots[k] - row.knots[k - 1], row.least_distance());
    };
    double limit = row.is_seam() ? row.knots.front() + row.period() : std::numeric_limits<double>::max();
    if (wall < row.knots.size()) {
        limit = row.knots[wall];
        for (std::size_t k = wall; k > moved; --k) limit -= kept_distance(k);
    }
    std::vector<double> knots = with_moved_at(row, std::max(row.knots[moved], std::min(row.target, limit)));
    const std::size_t end = row.is_seam() ? knots.size() - 1 : wall;
    const double highest = end < knots.size() ? knots[end] : std::numeric_limits<double>::max();
    for (std::size_t k = moved + 1; k < end; ++k)
        knots[k] = std::max(knots[k], std::min(knots[k - 1] + kept_distance(k), highest));
    return knots;
}

// The knot nearest to `u` within `distance`, other than the moved one; `u` itself when there is none.
double snapped(const KnotVector& knots, std::size_t index, double u, double distance) {
    const auto stored = knots.stored();
    const std::size_t last = stored.size() - 1;
    const double period = stored[last] - stored[0];
    const bool is_seam = knots.is_periodic() && (index == 0 || index == last);
    double nearest = u;
    const auto consider = [&](double knot) {
        if (std::abs(knot - u) > distance) return;
        nearest = knot;
        distance = std::abs(knot - u);
    };
    for (std::size_t k = 0; k < stored.size(); ++k) {
        if (k == index || (is_seam && (k == 0 || k == last))) continue;
        consider(stored[k]);
        if (knots.is_periodic()) consider(stored[k] - period);
        if (knots.is_periodic()) consider(stored[k] + period);
    }
    return nearest;
}

}  // namespace

Result<Curve> move_knot(const Curve& curve, std::size_t index, double u, KnotMove mode, double snap_distance,
                        Tears tears) {
    assert(snap_distance >= 0.0);
    const KnotVector& knots = curve.knots();
    const auto check = check_knot_index(curve, index).and_then([&] { return check_parameter_finite(u); });
    if (!check) return tl::unexpected(check.error());
    const double target = mode == KnotMove::snap ? snapped(knots, index, u, snap_distance) : u;
    const double from = knots.stored()[index];
    if (target == from) return curve;

    CurveDefinition definition = curve.definition();
    KnotRow row{curve.degree(),
                curve.is_periodic(),
                definition.tears == Tears::allow,
                mode == KnotMove::snap,
                tears == Tears::allow && !curve.is_periodic(),
                definition.knots,
                index,
                target};
    if (target < from) mirror(row);
    take_last_of_stack(row);
    row.knots = mode == KnotMove::push ? pushed(row) : stopped(row);
    if (target < from) mirror(row);
    if (row.knots == definition.knots) return curve;
    definition.knots = std::move(row.knots);
    definition.kind = KnotKind::custom;
    if (tears == Tears::allow) definition.tears = tears;
    return Curve::make(std::move(definition));
}

}  // namespace batten::core
