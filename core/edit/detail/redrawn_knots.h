/// A curve over new knots in a part of it, where its control points outside the part are known and those inside free.
#pragma once

#include <optional>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// Of an open curve inside the domain; of a closed one from inside the domain, perhaps beyond its end.
struct RedrawnPart {
    double from = 0.0;
    double to = 0.0;  ///< above `from`

    double length() const { return to - from; }
};

/// The knots of `curve` with `spans` even ones in the part, and at its ends so many that a spline over them is there as
/// smooth as curvature needs. Where the part leads through the seam of a closed curve, the seam is moved to its end.
Result<KnotVector> redrawn_knots(const Curve& curve, const RedrawnPart& part, std::size_t spans);

/// Control points over the new knots: those that decide the curve outside the part, to the bit where the knots that
/// they belong to are old ones. The others, which act inside alone, are `count` from `first` on, in a closed curve
/// perhaps behind its last point on from its first one.
struct RedrawnPoints {
    std::vector<Point> points{};
    std::vector<double> weights{};
    std::size_t first = 0;
    std::size_t count = 0;

    /// Which of them point i is; `count` or more for one that is known.
    std::size_t number_of_free(std::size_t i) const { return (i + points.size() - first) % points.size(); }
};

/// None where what stays cannot be described over these knots with weights above 0.
std::optional<RedrawnPoints> redrawn_points(const Curve& curve, const RedrawnPart& part, const KnotVector& knots);

}  // namespace batten::core
