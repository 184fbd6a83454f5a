/// A curve whose offset is asked for, and the true offset.
#pragma once

#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// A place of the true offset C + d N, with its derivative C' (1 - d * curvature).
struct OffsetPlace {
    Point point{};
    Vector derivative{};
    Vector tangent{};  ///< of the curve, of length 1
};

class OffsetSource {
  public:
    /// Of a curve that is not torn.
    OffsetSource(const Curve& curve, double distance);

    /// A clamped curve over the same domain.
    const Curve& curve() const { return curve_; }
    double distance() const { return distance_; }
    bool is_closed() const { return is_closed_; }

    /// Parts of the domain on which the curve is G2, in order. One that is_smoothly_closed goes on over the seam.
    const std::vector<Interval>& stretches() const { return stretches_; }
    bool is_smoothly_closed() const { return is_smoothly_closed_; }

    /// The true offset; beyond the domain of a curve that is smoothly closed it goes on. Error: curve_stands_still.
    Result<OffsetPlace> at(double u, Side side) const;

    /// The distinct knots within the part, ascending, with its ends.
    std::vector<double> breaks_within(Interval part) const;

  private:
    Curve curve_;
    double distance_;
    bool is_closed_;
    bool is_smoothly_closed_ = false;
    std::vector<Interval> stretches_{};
};

}  // namespace batten::core
