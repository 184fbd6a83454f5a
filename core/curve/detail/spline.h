/// Open splines of any point type on their way through an operation.
#pragma once

#include <cassert>
#include <iterator>
#include <optional>
#include <span>
#include <vector>

#include "core/curve/detail/boehm.h"
#include "core/curve/detail/bspline.h"

namespace batten::core {

/// points + p + 1 knots and their points. The point type is one that can be blended, as bspline.h says.
template <class P>
struct Spline {
    std::size_t p = 0;  ///< degree
    std::vector<double> knots{};
    std::vector<P> points{};

    Interval domain() const { return {knots[p], knots[points.size()]}; }

    /// The indices of the first and of the last knot that equals `u`, which there must be.
    std::size_t first_of_run(double u) const {
        assert(multiplicity(u) > 0);
        return static_cast<std::size_t>(std::lower_bound(knots.begin(), knots.end(), u) - knots.begin());
    }
    std::size_t last_of_run(double u) const {
        assert(multiplicity(u) > 0);
        return static_cast<std::size_t>(std::upper_bound(knots.begin(), knots.end(), u) - knots.begin()) - 1;
    }

    /// How often `u` is a knot.
    std::size_t multiplicity(double u) const {
        const auto run = std::equal_range(knots.begin(), knots.end(), u);
        return static_cast<std::size_t>(run.second - run.first);
    }
};

/// The points of a spline on their way into a longer array, as insert_ascending() fills it.
template <class P>
struct PointsOfSpline {
    std::span<const P> from;
    std::span<P> to;

    void copy(std::size_t first, std::size_t end, std::size_t place) const {
        copy_run(from.data(), first, end, to.data(), place);
    }
    void repeat(std::size_t i) const { to[i - 1] = to[i]; }
    void blend(std::size_t i, std::size_t count, const double* lower, const double* upper, double u) const {
        for (std::size_t j = 0; j < count; ++j)
            to[i - 1 + j] = blend_between(to[i - 1 + j], to[i + j], lower[j], upper[j], u);
    }
};

/// The same spline with the knots `added`, under the conditions of boehm.h.
template <class P>
void insert_ascending(Spline<P>& spline, std::span<const double> added) {
    assert(std::is_sorted(added.begin(), added.end()));
    assert(added.empty() || (spline.domain().contains(added.front()) && spline.domain().contains(added.back())));
    std::vector<double> knots(spline.knots.size() + added.size());
    std::vector<P> points(spline.points.size() + added.size());
    insert_ascending(spline.p, spline.knots, added, knots.data(), PointsOfSpline<P>{spline.points, points});
    spline.knots = std::move(knots);
    spline.points = std::move(points);
}

/// What must be added to `present` (ascending) so that it becomes `wanted` (ascending), which contains it.
inline std::vector<double> missing_knots(std::span<const double> wanted, std::span<const double> present) {
    assert(std::includes(wanted.begin(), wanted.end(), present.begin(), present.end()));
    std::vector<double> missing;
    std::set_difference(wanted.begin(), wanted.end(), present.begin(), present.end(), std::back_inserter(missing));
    return missing;
}

/// What must be inserted so that every knot of the domain has multiplicity p at least, and the points of each span are
/// those of its Bézier piece.
template <class P>
std::vector<double> knots_missing_for_pieces(const Spline<P>& spline) {
    const Interval domain = spline.domain();
    std::vector<double> missing;
    for (std::size_t first = spline.first_of_run(domain.lower); first < spline.knots.size();) {
        const double u = spline.knots[first];
        if (u > domain.upper) break;
        std::size_t end = first;
        while (end < spline.knots.size() && spline.knots[end] == u) ++end;
        missing.insert(missing.end(), spline.p - std::min(spline.p, end - first), u);
        first = end;
    }
    return missing;
}

/// The part between `a` and `b`, which must be in the domain, a < b; its ends get multiplicity p+1, at a tear on their
/// own side of it. Without `a` or `b` that end stays as it is. Cost O(p^2) plus the copying.
template <class P>
Spline<P> part_between(Spline<P> spline, std::optional<double> a, std::optional<double> b) {
    const std::size_t p = spline.p;
    assert(!a || spline.domain().contains(*a));
    assert(!b || spline.domain().contains(*b));
    assert(!a || !b || *a < *b);
    std::vector<double> added;
    for (const std::optional<double>& u : {a, b})
        if (u) added.insert(added.end(), p - std::min(p, spline.multiplicity(*u)), *u);
    insert_ascending<P>(spline, added);
    const std::size_t after_a = a ? spline.last_of_run(*a) + 1 : 0;
    const std::size_t before_b = b ? spline.first_of_run(*b) : spline.knots.size();
    const std::size_t first_point = a ? after_a - p - 1 : 0;
    const std::size_t end_point = b ? before_b : spline.points.size();
    Spline<P> part{.p = p};
    if (a) part.knots.assign(p + 1, *a);
    const auto at = [](auto& values, std::size_t i) { return values.begin() + static_cast<std::ptrdiff_t>(i); };
    part.knots.insert(part.knots.end(), at(spline.knots, after_a), at(spline.knots, before_b));
    if (b) part.knots.insert(part.knots.end(), p + 1, *b);
    part.points.assign(at(spline.points, first_point), at(spline.points, end_point));
    return part;
}

/// The spline seen from behind: the point at u comes to -u. Exact, and its own inverse.
template <class P>
Spline<P> mirrored(Spline<P> spline) {
    std::reverse(spline.knots.begin(), spline.knots.end());
    for (double& knot : spline.knots) knot = -knot;
    std::reverse(spline.points.begin(), spline.points.end());
    return spline;
}

}  // namespace batten::core
