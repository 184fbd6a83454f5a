/// All joints of several curves: ends near each other, and knots at which a curve is not smooth.
#pragma once

#include <span>
#include <vector>

#include "core/curve/curve.h"
#include "core/curve/curve_end.h"
#include "core/measure/meeting.h"

namespace batten::core {

/// A side of a joint: an end of a curve, or an inner knot of it.
struct JointPlace {
    std::size_t curve = 0;  ///< its index
    double u = 0.0;         ///< where in its domain
    bool is_end = true;     ///< else a knot
};

struct Joint {
    JointPlace first;
    JointPlace second;  ///< the same one at a knot or a seam
    Point place{};      ///< of the first side
    Meeting meeting{};  ///< run through from the first side into the second
    int level = -1;     ///< as smoothness_of() says, 3 for G3
};

/// Each end with the one nearest to it within `tolerance` (> 0) and with all that it meets, each pair once; and the
/// knots and seams at which a curve is less smooth than G2 by its shape; in the order of the curves and their
/// parameters, knots of a curve before its ends. A level counts gaps up to 1e-9 of the size of both curves as none.
/// Cost O(n p^3) and O(m log m) for m ends that lie about evenly.
std::vector<Joint> joints_of(std::span<const Curve* const> curves, double tolerance);

}  // namespace batten::core
