/// Newton's iterations for what two pieces have in common.
#pragma once

#include <optional>

#include "core/evaluate/detail/piece_motion.h"

namespace batten::core {

/// Parameters on two pieces.
struct ShareContact {
    double first = 0.0;
    double second = 0.0;
};

/// The intersection of two pieces near `start`, by Newton's iteration for A(t) = B(s); t and s are cut to [0, 1] at the
/// end. None where it does not converge or the points are then farther apart than `tolerance`.
std::optional<ShareContact> crossing_near(const PieceMotion& a, const PieceMotion& b, ShareContact start,
                                          double tolerance);

/// The place near `start` where the tangents are parallel and A(t) - B(s) is normal to them, with t within `range`, so
/// a tangential contact if there is one. None where the points are farther apart than `tolerance`.
std::optional<ShareContact> touching_near(const PieceMotion& a, const PieceMotion& b, ShareContact start,
                                          Interval range, double tolerance);

/// The s in [0, 1] near `start` for which B(s) is nearest to `point`.
double foot_near(const PieceMotion& b, Point point, double start);

/// The s in [0, 1] for which B(s) is nearest to `point`, started from samples.
double foot(const PieceMotion& b, Point point);

}  // namespace batten::core
