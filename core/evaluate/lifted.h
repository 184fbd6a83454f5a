/// The curve one dimension up, of which the curve in the plane is the shadow, and how it is shown in space.
#pragma once

#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// How homogeneous points are shown. Seen from `apex`, which lies in the plane w = 1 above the origin of space, and
/// with `unit` as length, the point (x, y) with weight w is shown at h (x, y, 1), h = w^exponent: on the ray from the
/// origin through its shadow (x, y, 1), whatever the exponent, and with the exponent 1 at (wx, wy, w) itself.
struct LiftView {
    Point apex{};
    double unit = 1.0;      ///< > 0
    double exponent = 1.0;  ///< above 0, at most 1

    bool operator==(const LiftView&) const = default;

    /// Where the point with that shadow and weight (> 0) is shown.
    glm::dvec3 place(Point shadow, double weight) const;

    /// Whose height is h = 1: the shadow itself.
    glm::dvec3 place(Point shadow) const { return place(shadow, 1.0); }

    /// The weight of what is shown `height` (> 0) high.
    double weight_at(double height) const;
};

/// No weight is shown higher than this, nor lower than its inverse.
inline constexpr double greatest_lift = 3.0;

/// A view of points in `box` (not empty) with weights in `weights` (> 0): the apex below the middle of the box,
/// its longer side as unit, and the exponent 1 where the weights are so moderate that all are within greatest_lift;
/// else the one that brings the most extreme of them there. With another exponent than 1 a leg is bent in space.
LiftView lift_view(const Box& box, Interval weights);

/// A point of the lifted curve by its shadow and height.
struct LiftedSample {
    double u = 0.0;
    Point point{};
    double weight = 1.0;
};

/// The point of the lifted curve at `u`, brought into the domain; from `side` at a tear. Cost O(p^2 + log n).
LiftedSample lifted_at(const Curve& curve, double u, Side side = Side::right);

/// How finely a lifted curve is sampled.
struct LiftedFineness {
    double tolerance = 1e-3;      ///< > 0, in space: a chord is halved while its middle is farther from the curve
    std::size_t most_spans = 64;  ///< above 0: of a curve with more spans only so many of their ends are taken

    bool operator==(const LiftedFineness&) const = default;
};

/// Samples that show the curve in space, ascending: at least 5 in each span, and at most 4097; a new run after a tear.
std::vector<std::vector<LiftedSample>> lifted_samples(const Curve& curve, const LiftView& view,
                                                      LiftedFineness fineness);

}  // namespace batten::core
