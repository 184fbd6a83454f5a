/// Points and velocities of one Bézier piece, for integrating along it.
#pragma once

#include <cassert>
#include <span>
#include <vector>

#include "core/curve/detail/bspline.h"
#include "core/evaluate/bezier_pieces.h"

namespace batten::core {

/// Where a point moving along a piece is and how fast.
struct Motion {
    Point position{};
    Vector velocity{};  ///< dC/dt for t from 0 to 1 over the piece, whatever its interval is
};

/// One piece as a function of t, which loses no digits where the knots are close together and far from zero. Within
/// [0, 1] it is finite; beyond, weights may vanish.
class PieceMotion {
  public:
    /// `piece` has 2 to max_degree + 1 points.
    explicit PieceMotion(BezierPiece piece) : piece_(std::move(piece)) {
        assert(2 <= piece_.points.size() && piece_.points.size() <= max_degree + 1);
        for (const HomogeneousPoint& point : piece_.points)
            is_polynomial_ = is_polynomial_ && point.z == piece_.points.front().z;
    }

    Interval interval() const { return piece_.interval; }

    /// Cost O(p^2). Source: de Casteljau.
    Motion at(double t) const { return at({1.0 - t, t}); }

    /// At the share `ratio.upper_share`, which says as well how near the end is: the smaller share counts.
    Motion at(Ratio ratio) const;

    /// The velocity alone, within the rounding of that of at(). Cost O(p) where all weights are equal.
    Vector velocity_at(Ratio ratio) const;

    /// Whether all weights are equal.
    bool is_polynomial() const { return is_polynomial_; }

    /// The Bézier points, seen from the origin of the motion.
    std::span<const HomogeneousPoint> points() const { return piece_.points; }

  private:
    Motion polynomial_at(Ratio ratio) const;
    Motion rational_at(Ratio ratio) const;

    BezierPiece piece_;
    bool is_polynomial_ = true;
};

/// The pieces over the non-empty spans among `first`..`last`, spans of the domain, as the curve stands.
std::vector<PieceMotion> motions_of(const Curve& curve, std::size_t first, std::size_t last);

/// All pieces of `curve`, seen from `origin`.
std::vector<PieceMotion> motions_of(const Curve& curve, Point origin);

}  // namespace batten::core
