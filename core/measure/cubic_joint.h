/// What neighboring control points make of a joint of uniform cubic segments, and where two uniform cubics join.
#pragma once

#include "core/base/names.h"
#include "core/curve/curve.h"
#include "core/evaluate/uniform_cubic.h"

namespace batten::core {

/// What P_{i-1}, P_i, P_{i+1} are to each other.
enum class CubicJointCase {
    triangle,   ///< the common one
    collinear,  ///< on one line: the joint is on it, and the curve touches it there without curvature
    centered,   ///< P_i midway between the others: the curve passes through P_i, with no second derivative
    doubled,    ///< P_i equals one neighbor: the joint is a sixth along the leg to the other one, without curvature
    folded,     ///< the neighbors are equal: the joint is a third along the leg to them, and the speed is zero there
    tripled     ///< all equal: the curve passes through P_i, with no first and second derivative
};

template <>
struct Names<CubicJointCase> {
    using enum CubicJointCase;
    static constexpr std::array table{
        Named{triangle, "triangle", "triangle"},      Named{collinear, "collinear", "collinear"},
        Named{centered, "centered", "midway vertex"}, Named{doubled, "doubled", "double vertex"},
        Named{folded, "folded", "equal neighbors"},   Named{tripled, "tripled", "triple vertex"}};
};

/// Points are equal or on one line up to the tolerance of collinear_runs, of the box of these three.
CubicJointCase case_of(const Anticentroid& joint);

/// Whether segment `k` (below their count) of a uniform cubic is straight: its four control points are on one line, up
/// to the same tolerance of their box.
bool is_straight_segment(const Curve& curve, std::size_t k);

/// The last joint of one uniform cubic and the first joint of another. With the parameter counted in knot steps they
/// join with C0 where the anticentroids are equal, with C1 where the tangents are too, and with C2 where the second
/// derivatives are too. All three equations together say that the three vertices themselves are the same.
struct CubicMeeting {
    Anticentroid first;
    Anticentroid second;
    int continuity = -1;           ///< 0 to 2; -1 where the curves are apart
    bool has_equal_steps = false;  ///< of the knots, up to rounding: then the derivatives by u agree as far
};

/// Where `first` ends and `second` begins, both open uniform polynomial cubics. Points may differ by
/// default_closing_tolerance times the larger side of the box of the six vertices, vectors by six times that. Cost
/// O(1).
CubicMeeting meeting_of_cubics(const Curve& first, const Curve& second);

}  // namespace batten::core
