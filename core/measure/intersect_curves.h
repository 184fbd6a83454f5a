/// Where two curves meet, and where one meets itself.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/curve/curve.h"

namespace batten::core {

/// A point, or an interval, that two curves have in common.
struct CurveContact {
    Interval on_first;          ///< parameters on the first curve: one, or an interval on which the curves coincide
    double second_begin = 0.0;  ///< the parameter on the second curve that belongs to on_first.lower
    double second_end = 0.0;    ///< and to on_first.upper; less than second_begin where they run against each other
    double u = 0.0;             ///< the middle of on_first
    double v = 0.0;             ///< the middle on the second curve
    Point point{};              ///< the first curve at u
    bool is_tangent = false;    ///< the tangents are parallel to 1e-6; true on an interval

    bool is_overlap() const { return on_first.length() > 0.0; }
};

/// What two curves, or one with itself, have in common.
struct CurveContacts {
    std::vector<CurveContact> contacts;  ///< in order of u
    /// Whether nothing had to be left undecided: pieces that run along each other nearer than doubles can tell, without
    /// being the same, or whose weights are too far apart.
    bool is_complete = true;
};

/// All contacts, in order of u, each once: crossings, tangential contacts, and intervals on which the curves coincide.
/// Found by subdivision, so none is missed that is farther than 2^-22 of the size of the
/// smaller curve from others; finished by Newton's iteration. Points nearer than 1e-13 of the size of both curves are
/// taken to meet. Where the ends of a curve meet they are one place, the lower end. Of two Bézier pieces that coincide
/// on an interval no further contacts are sought; a double point of curves that coincide is a crossing of other pieces.
/// Cost: O(log n) comparisons of boxes for each piece and for each pair of pieces that are near, and a few dozen
/// halvings for each contact; the number of halvings is bounded.
CurveContacts intersect_curves(const Curve& first, const Curve& second, const Progress& progress = {});

/// The places where the curve passes through a point a second time, on_first before second_begin, in the same way.
/// Where the ends meet they are no self-intersection, and neither is a cusp; loops smaller than 2^-22 of the curve are
/// not seen. A point passed three times makes three contacts.
CurveContacts self_intersections(const Curve& curve, const Progress& progress = {});

}  // namespace batten::core
