/// Linear conditions on the control points of a spline, of which the control points are computed.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/detail/banded_least_squares.h"
#include "core/curve/knot_vector.h"

namespace batten::core {

/// A control point that is known beforehand; only an open spline has such.
struct KnownPoint {
    std::size_t index = 0;
    Point point{};
};

/// A control point between a known point and another control point: P_index = from + share (P_to - from).
struct BoundPoint {
    std::size_t index = 0;
    Point from{};
    std::size_t to = 0;  ///< neither known nor bound
    double share = 0.0;
};

/// The control points of an open spline that are not free.
struct EndPoints {
    std::vector<KnownPoint> known{};
    std::vector<BoundPoint> bound{};
    bool meet = false;  ///< whether sums reach from the last points to the first
};

/// Collects conditions and solves them: exactly when they are as many as the unknown control points, by least squares
/// when they are more. Coordinates are computed from an origin, which should lie near the points.
class SplineSystem {
  public:
    SplineSystem(KnotVector knots, Point origin, const EndPoints& ends = {});

    /// The spline shall be at `point` for `u`. Cost O(p^2).
    void require_point(double u, Point point);

    /// The derivative of order `order` >= 1 at `u` shall be `value`. The condition counts `weight` times in the errors
    /// that are squared. Cost O(p^2).
    void require_derivative(double u, int order, Vector value, double weight = 1.0);

    /// sum of coefficients[j] (P_{first + j} - origin) shall be `right`; indices are those of the unrolled spline,
    /// which an open one has where its ends meet.
    void require_sum(std::size_t first, std::span<const double> coefficients, Vector right);

    /// All control points; none where the conditions do not determine them. As many conditions on the spline, of order
    /// up to 2, as unknowns are met to the last digits of the control points. Cost O(m p^2) for m conditions.
    std::optional<std::vector<Point>> solve(const Progress& progress = {}) const;

    const KnotVector& knots() const { return knots_; }

  private:
    static constexpr std::size_t is_known = static_cast<std::size_t>(-1);

    /// What is required at `u`, the spline and its derivatives being seen from `origin`.
    struct Site {
        double u = 0.0;
        int order = 0;
        Point origin{};
        Vector value{};
        double weight = 1.0;
    };

    void require(const Site& site);
    std::vector<Point> refined(std::vector<Point> points) const;

    KnotVector knots_;
    Point origin_;
    // Control point i is origin + points_[i] + shares_[i] times the unknown number unknown_[i].
    std::vector<Vector> points_;
    std::vector<double> shares_;
    std::vector<std::size_t> unknown_;  ///< or is_known
    std::size_t unknown_count_ = 0;
    bool is_ring_ = false;  ///< whether the last points are neighbors of the first
    std::vector<BandedEquation<Vector>> equations_;
    std::vector<Site> sites_;  ///< where the equations come from; fewer than equations when some are sums
};

}  // namespace batten::core
