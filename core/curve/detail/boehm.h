/// Boehm's insertion of knots, for points of every kind, wherever they are kept.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

namespace batten::core {

/// New knots often lie so close to one another that this many values between them are handled at once, without asking
/// how many they are.
inline constexpr std::size_t handled_at_once = 4;

/// How many of the ascending values are not above `u`. Cost: the logarithm of how many are above it.
inline std::size_t count_not_far_above(std::span<const double> ascending, double u) {
    std::size_t count = ascending.size();
    std::size_t step = 1;
    while (step <= count && ascending[count - step] > u) {
        count -= step;
        step *= 2;
    }
    const auto near = ascending.subspan(count - std::min(count, step), std::min(count, step));
    return count - near.size() + static_cast<std::size_t>(std::upper_bound(near.begin(), near.end(), u) - near.begin());
}

/// The same, made for values among the last ones.
[[gnu::always_inline]] inline std::size_t count_not_above(std::span<const double> ascending, double u) {
    const std::size_t count = ascending.size();
    if (count < handled_at_once) return count_not_far_above(ascending, u);
    std::size_t above = 0;
    for (std::size_t k = 1; k <= handled_at_once; ++k) above += ascending[count - k] > u ? 1U : 0U;
    return above < handled_at_once ? count - above : count_not_far_above(ascending, u);
}

/// Copies values from[first..end) to where to[place) ends; may write some values before them, too.
template <class T>
[[gnu::always_inline]] inline void copy_run(const T* from, std::size_t first, std::size_t end, T* to,
                                            std::size_t place) {
    if (end - first <= handled_at_once && end >= handled_at_once)
        for (std::size_t k = 1; k <= handled_at_once; ++k) to[place - k] = from[end - k];
    else
        std::copy(from + first, from + end, to + (place - (end - first)));
}

/// Where knots came in.
struct InsertedRange {
    std::size_t first = 0;         ///< the first new point that is not an old one
    std::size_t end = 0;           ///< and the one behind the last
    bool has_equal_knots = false;  ///< an added knot equals another one
};

/// Fills `knots`, which has room for both, with the `old_knots` of a spline of degree p and `added`, which are
/// ascending, lie in the domain and leave every multiplicity at most p, or p+1 at the ends of the domain. `points`
/// fills its own new array, of as many points more, from the right:
///
///     points.copy(first, end, place)      new points up to `place` are the old ones from `first` to `end`
///     points.repeat(i)                    new point i-1 is new point i
///     points.blend(i, count, lower, upper, u)  new point i-1+j is the combination at u of itself, at lower[j], and
///                                         the next one, at upper[j], for j from 0 to count-1
///
/// The new points outside of the range returned are old ones. Every new point is a convex combination of old ones, and
/// only what an added knot reaches is computed. Cost: at most p blends for each knot, and one copy of everything.
/// Source: Boehm 1980; Boehm and Prautzsch 1985; The NURBS Book, A5.4.
template <class Degree, class Points>
InsertedRange insert_ascending(Degree p, std::span<const double> old_knots, std::span<const double> added,
                               double* knots, const Points& points) {
    // Knot i+p+1 and point i move together.
    const std::span<const double> upper_knots = old_knots.subspan(p + 1);
    double* new_upper_knots = knots + p + 1;
    std::size_t old_count = upper_knots.size();
    std::size_t place = old_count + added.size();
    const double end = upper_knots[old_count - p - 1];
    InsertedRange changed;
    const double before_end = std::nextafter(end, -std::numeric_limits<double>::infinity());
    for (std::size_t r = added.size(); r-- > 0;) {
        const double u = added[r];
        // A knot comes in behind its equals, at the domain's end before them: so there always is a span on its left.
        const std::size_t kept = count_not_above(upper_knots.first(old_count), u == end ? before_end : u);
        copy_run(upper_knots.data(), kept, old_count, new_upper_knots, place);
        points.copy(kept, old_count, place);
        place -= old_count - kept;
        old_count = kept;
        if (changed.end == 0) changed.end = place + p;

        // Blends only points whose knots do not equal u: Q_i = (1 - alpha_i) P_{i-1} + alpha_i P_i, alpha_i = (u - u_i)
        // / (u_{i+p} - u_i).
        points.repeat(place);
        const double* lower = &old_knots[old_count + 1];
        const double* upper = &new_upper_knots[place];
        if (lower[p - 1] < u && u < upper[0]) {
            points.blend(place + 1, p, lower, upper, u);
        } else {
            changed.has_equal_knots = true;
            for (std::size_t j = 0; j < p; ++j) {
                if (upper[j] == u)
                    points.repeat(place + 1 + j);
                else if (lower[j] < u)
                    points.blend(place + 1 + j, std::integral_constant<std::size_t, 1>(), lower + j, upper + j, u);
            }
        }
        new_upper_knots[--place] = u;
    }
    std::copy_n(old_knots.data(), old_count + p + 1, knots);
    points.copy(0, old_count, old_count);
    changed.first = old_count;
    return changed;
}

}  // namespace batten::core
