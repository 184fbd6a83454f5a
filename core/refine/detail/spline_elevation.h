/// Raises the degree of a spline by one through convex combinations only, for every point type.
///
/// A control point of the higher degree is the mean of the p+1 blossoms whose arguments are its own p+1 knots without
/// one of them. Leave every (p+1)-th knot out of the new vector, in each of the p+1 possible ways: what remains
/// contains the old knots, so that the old spline can be refined to it, and the control points of the p+1 refinements
/// are those blossoms. Source: Prautzsch 1984; Prautzsch and Piper 1991.
#pragma once

#include <cassert>

#include "core/curve/detail/spline.h"

namespace batten::core {

/// Every run of equal knots with one knot more.
inline std::vector<double> with_longer_runs(std::span<const double> knots) {
    std::vector<double> longer;
    longer.reserve(2 * knots.size());
    for (std::size_t i = 0; i < knots.size(); ++i) {
        longer.push_back(knots[i]);
        if (i + 1 == knots.size() || knots[i + 1] != knots[i]) longer.push_back(knots[i]);
    }
    return longer;
}

/// One of the ways to leave every (p+1)-th knot out; the outermost knots stay, which no window reaches.
struct KnotComb {
    std::size_t step = 0;   ///< p+1
    std::size_t phase = 0;  ///< 0..p
    std::size_t last = 0;   ///< the index of the last knot

    bool leaves_out(std::size_t i) const { return i > 0 && i < last && i % step == phase; }

    /// How many of the knots 0..i, i < last, are left out.
    std::size_t left_out_until(std::size_t i) const {
        assert(i < last);
        if (phase == 0) return i / step;
        return i < phase ? 0 : (i - phase) / step + 1;
    }
};

/// The spline in degree p+1; its ends have multiplicity p+1, and no other knot has. Cost O(p) refinements, so O(p^2)
/// for each new point.
template <class P>
Spline<P> elevated_clamped(const Spline<P>& spline) {
    assert(spline.multiplicity(spline.knots.front()) == spline.p + 1);
    assert(spline.multiplicity(spline.knots.back()) == spline.p + 1);
    Spline<P> result{.p = spline.p + 1, .knots = with_longer_runs(spline.knots)};
    const std::size_t step = result.p;
    const std::size_t count = result.knots.size() - result.p - 1;
    std::vector<P> sums;
    for (std::size_t phase = 0; phase < step; ++phase) {
        const KnotComb comb{step, phase, result.knots.size() - 1};
        std::vector<double> wanted;
        for (std::size_t i = 0; i < result.knots.size(); ++i)
            if (!comb.leaves_out(i)) wanted.push_back(result.knots[i]);
        Spline<P> refined = spline;
        insert_ascending(refined, missing_knots(wanted, spline.knots));
        const auto blossom_of = [&](std::size_t j) { return refined.points[j - comb.left_out_until(j)]; };
        for (std::size_t j = 0; j < count; ++j) {
            if (phase == 0) result.points.push_back(blossom_of(j));
            if (phase == 0) sums.push_back(result.points[j] - result.points[j]);
            sums[j] = sums[j] + (blossom_of(j) - result.points[j]);
        }
    }
    for (std::size_t j = 0; j < count; ++j)
        result.points[j] = result.points[j] + (1.0 / static_cast<double>(step)) * sums[j];
    return result;
}

/// The same where knots inside may have multiplicity p+1: the parts between these tears are elevated one by one.
template <class P>
Spline<P> elevated_torn(const Spline<P>& spline) {
    const std::size_t p = spline.p;
    Spline<P> result{.p = p + 1};
    std::size_t first = 0;
    for (std::size_t i = 1; i + p < spline.knots.size(); ++i) {
        if (spline.knots[i] != spline.knots[i + p]) continue;
        Spline<P> part{.p = p};
        const auto knots = std::span(spline.knots).subspan(first, i + p + 1 - first);
        const auto points = std::span(spline.points).subspan(first, i - first);
        part.knots.assign(knots.begin(), knots.end());
        part.points.assign(points.begin(), points.end());
        const Spline<P> raised = elevated_clamped(part);
        const std::size_t shared = first == 0 ? 0 : p + 2;
        result.knots.insert(result.knots.end(), raised.knots.begin() + static_cast<std::ptrdiff_t>(shared),
                            raised.knots.end());
        result.points.insert(result.points.end(), raised.points.begin(), raised.points.end());
        first = i;
    }
    return result;
}

/// The spline in degree p+1 over the same domain, every multiplicity one higher; outside the domain as many knots stay
/// as the new degree needs. Points that act nowhere in the domain stay as they are. `zero` is the neutral point.
template <class P>
Spline<P> elevated(const Spline<P>& spline, const P& zero) {
    const std::size_t p = spline.p;
    const Interval domain = spline.domain();
    // Outside its knots the spline is continued by nothing, which has no share in what acts in the domain.
    const std::size_t before = p + 1 - spline.multiplicity(spline.knots.front());
    const std::size_t after = p + 1 - spline.multiplicity(spline.knots.back());
    Spline<P> padded{.p = p, .knots = std::vector(before, spline.knots.front()), .points = std::vector(before, zero)};
    padded.knots.insert(padded.knots.end(), spline.knots.begin(), spline.knots.end());
    padded.knots.insert(padded.knots.end(), after, spline.knots.back());
    padded.points.insert(padded.points.end(), spline.points.begin(), spline.points.end());
    padded.points.insert(padded.points.end(), after, zero);
    const Spline<P> whole = elevated_torn(padded);

    const auto runs_in = [&](std::size_t first) {
        const auto knots = std::span(spline.knots).subspan(first, p + 1);
        std::size_t runs = 1;
        for (std::size_t i = 1; i < knots.size(); ++i) runs += knots[i] != knots[i - 1] ? 1U : 0U;
        return runs;
    };
    const std::size_t left_out = before + runs_in(0) - 1;
    const std::size_t right_out = after + runs_in(spline.knots.size() - p - 1) - 1;
    const auto knots = std::span(whole.knots).subspan(left_out, whole.knots.size() - left_out - right_out);
    Spline<P> result{.p = p + 1, .knots = {knots.begin(), knots.end()}};
    const std::size_t count = result.knots.size() - p - 2;
    for (std::size_t j = 0; j < count; ++j) {
        if (result.knots[j + p + 2] <= domain.lower)
            result.points.push_back(spline.points[j]);
        else if (result.knots[j] >= domain.upper)
            result.points.push_back(spline.points[spline.points.size() - (count - j)]);
        else
            result.points.push_back(whole.points[j + left_out]);
    }
    return result;
}

}  // namespace batten::core
