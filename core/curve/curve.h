/// The NURBS curve: an immutable, always valid value of knots, control points and weights.
#pragma once

#include <span>
#include <vector>

#include "core/curve/knot_vector.h"

namespace batten::core {

/// Unchecked input from which a curve is made; the members of the native file.
struct CurveDefinition {
    int degree = 3;
    std::vector<double> knots{};  ///< the full vector, or n+1 knots of one period when periodic
    std::vector<Point> points{};
    std::vector<double> weights{};  ///< empty means all 1
    bool periodic = false;
    KnotKind kind = KnotKind::custom;
    Tears tears = Tears::refuse;
};

/// A piecewise rational curve C(u) = sum N_{i,p}(u) w_i P_i / sum N_{i,p}(u) w_i over the domain of its knots.
class Curve {
  public:
    /// Checked in this order: degree, too few points (p+1, or 2 when periodic), knot count against points, everything
    /// else that KnotVector checks, points finite, weight count, weights finite, weights positive.
    [[nodiscard]] static Result<Curve> make(CurveDefinition definition);

    /// The curve over knots that are already known to be valid. Checked in this order: knot count against points,
    /// points finite, weight count, weights finite, weights positive.
    [[nodiscard]] static Result<Curve> make(KnotVector knots, std::vector<Point> points, std::vector<double> weights);

    int degree() const { return knots_.degree(); }
    bool is_periodic() const { return knots_.is_periodic(); }
    const KnotVector& knots() const { return knots_; }
    Interval domain() const { return knots_.domain(); }

    /// Copies of a curve share them, as they share its knots.
    std::span<const Point> control_points() const { return points_.values(); }
    std::span<const double> weights() const { return weights_.values(); }

    /// Not all weights are equal.
    bool is_rational() const { return is_rational_; }

    /// Whether a knot inside the domain has multiplicity p+1, so that the curve may come apart there. Cost O(n).
    bool is_torn() const;

    /// Control point i of the unrolled curve, which is point i mod n when periodic.
    HomogeneousPoint homogeneous_point(std::size_t i) const {
        const std::size_t k = i % points_.size();
        return lift(points_[k], weights_[k]);
    }

    /// The definition that makes this curve again.
    CurveDefinition definition() const;

    bool operator==(const Curve&) const = default;

  private:
    friend struct Trusted;

    Curve(KnotVector knots, SharedArray<Point> points, SharedArray<double> weights, bool is_rational);

    KnotVector knots_;
    SharedArray<Point> points_;
    SharedArray<double> weights_;
    bool is_rational_ = false;
};

}  // namespace batten::core
