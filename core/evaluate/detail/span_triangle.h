/// The triangle of one span (bspline.h) at one parameter, for several sets of points.
#pragma once

#include <algorithm>
#include <array>
#include <bit>

#include "core/curve/detail/bspline.h"
#include "core/curve/detail/known_degree.h"

namespace batten::core {

/// Both coordinates in one register. The compiler does not come to it by itself where one of two points is chosen.
using Pair [[gnu::vector_size(16)]] = double;

/// The p+1 local points of one span.
template <class Degree>
using LocalPairs = std::array<Pair, most_local_points<Degree>>;

/// Its shares are computed once. Like blend of bspline.h it starts from the nearer of two points, but never by a
/// branch: at a random parameter no processor could guess which one that is.
template <class Degree>
class SpanTriangle {
  public:
    SpanTriangle(const SpanKnots& at, Degree p, double u) : p_(p) {
        for_each_level(p, p, [&](auto r) {
            for (std::size_t j = r; j <= p_; ++j) levels_[r - 1][j - 1] = step_at(at.lower(j), at.upper(j, r), u);
        });
    }

    /// The spline after `levels_done` levels, as de_boor gives it.
    Pair apex(const LocalPairs<Degree>& local, std::size_t levels_done = 0) const {
        LocalPairs<Degree> points;
        std::copy(local.begin() + levels_done, local.begin() + p_ + 1, points.begin() + levels_done);
        for_each_level(p_, p_, [&](auto r) {
            if (r <= levels_done) return;
            for (std::size_t j = p_; j >= r; --j) points[j] = blended(points[j - 1], points[j], levels_[r - 1][j - 1]);
        });
        return points[p_];
    }

  private:
    using Choice = decltype(Pair() <= Pair());

    struct Step {
        Pair share;  // from the nearer one: upper_share or -lower_share
        Choice is_nearer_lower;
    };

    static Step step_at(double lower, double upper, double u) {
        const Pair from_lower{u - lower, u - lower};
        const Pair from_upper{u - upper, u - upper};
        const Pair length{upper - lower, upper - lower};
        const Choice is_nearer_lower = from_lower <= -from_upper;
        return {(is_nearer_lower ? from_lower : from_upper) / length, is_nearer_lower};
    }

    static Pair blended(Pair a, Pair b, const Step& step) {
        const Choice nearer =
            (std::bit_cast<Choice>(a) & step.is_nearer_lower) | (std::bit_cast<Choice>(b) & ~step.is_nearer_lower);
        return std::bit_cast<Pair>(nearer) + step.share * (b - a);
    }

    Degree p_;
    std::array<std::array<Step, most_local_points<Degree>>, most_local_points<Degree>> levels_;
};

}  // namespace batten::core
