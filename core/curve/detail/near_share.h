/// Combinations of two points at a parameter between their knots, computed from the nearer one and without a branch,
/// for the operations that form very many of them.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "core/base/geometry.h"

namespace batten::core {

/// A control point and its weight.
struct WeightedPoint {
    Point point;
    double weight;
};

/// (1 - share) near + share far, for shares up to 1/2: bit-equal to `near` where the share is 0 or both are equal.
template <class P>
P combined(const P& near, const P& far, double share) {
    return near + share * (far - near);
}

/// The shadow of the combination one dimension up: it lies on the leg between the two points, where the weights say, so
/// nothing is lifted and projected. No weight is too small or too large.
inline WeightedPoint combined(const WeightedPoint& near, const WeightedPoint& far, double share) {
    const double larger = std::max(near.weight, far.weight);
    const double pull_of_near = (1.0 - share) * (near.weight / larger);
    const double pull_of_far = share * (far.weight / larger);
    const double lesser_share = std::min(pull_of_near, pull_of_far) / (pull_of_near + pull_of_far);
    const bool is_near_main = pull_of_near >= pull_of_far;
    const Point main = is_near_main ? near.point : far.point;
    const Point other = is_near_main ? far.point : near.point;
    return {main + lesser_share * (other - main), near.weight + share * (far.weight - near.weight)};
}

/// Which of two neighbors is nearer to a parameter, and the share of the other one, at most 1/2.
struct NearShare {
    std::size_t is_upper_near;
    double of_far;

    /// The combination of two points, or values, that stand one after the other.
    template <class P>
    P between(const P* pair) const {
        return combined(pair[is_upper_near], pair[1 - is_upper_near], of_far);
    }
};

/// The share of `u` between two knots, lower < upper. It is the quotient of two differences of knots.
inline NearShare near_share(double lower, double upper, double u) {
    assert(lower < upper);
    const double from_lower = u - lower;
    const double from_upper = upper - u;
    return {from_upper < from_lower ? 1U : 0U, std::min(from_lower, from_upper) / (upper - lower)};
}

}  // namespace batten::core
