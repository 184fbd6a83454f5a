/// In which way a curve is closed, told by its data and never by a flag.
#pragma once

#include "core/base/names.h"
#include "core/curve/curve.h"

namespace batten::core {

enum class Closing {
    open,       ///< the ends do not meet
    ends_meet,  ///< the first and the last point of the curve are one
    wrapped,    ///< an open curve whose last p control points are the first p again, over knots that repeat likewise
    periodic    ///< no ends at all: n points, one period of knots
};

template <>
struct Names<Closing> {
    static constexpr std::array table{
        Named{Closing::open, "open", "open"}, Named{Closing::ends_meet, "ends-meet", "ends meet"},
        Named{Closing::wrapped, "wrapped", "wrapped control points"}, Named{Closing::periodic, "periodic", "periodic"}};
};

/// Ends that are nearer than this part of the curve's size meet.
inline constexpr double default_closing_tolerance = 1e-9;

struct ClosingReport {
    Closing closing = Closing::open;
    double gap = 0.0;  ///< the distance of the two ends of the domain on the curve; exactly 0 when periodic
    /// How many derivatives agree across the closing point: 0 for a corner; -1 when open; p for a polynomial that
    /// simply goes on. For a periodic curve what its seam promises, p - multiplicity; otherwise measured.
    int continuity = -1;
};

/// How `curve` is closed. What is compared may differ by `tolerance` (> 0) times the larger side of the box of its
/// control points, a derivative of order k by so much times p^k / h^k with h the shorter of the spans at the ends, and
/// by the rounding of coordinates and knots. The p points are compared one by one together with their weights. Cost
/// O(n + p^3).
ClosingReport closing_of(const Curve& curve, double tolerance = default_closing_tolerance);

/// The length that `relative` (>= 0) means for `curve`: times the larger side of the box of its control points, and
/// never less than the rounding of their coordinates.
double absolute_tolerance(const Curve& curve, double relative);

/// The same for points in `box`, which is not empty.
double absolute_tolerance(const Box& box, double relative);

}  // namespace batten::core
