/// The velocity along a polynomial piece of low degree as a polynomial, for quick quadrature.
#pragma once

#include <array>

#include "core/base/detail/quadrature.h"
#include "core/evaluate/detail/piece_motion.h"

namespace batten::core {

/// dC/dt as powers of the way from the middle of the piece, s = t - 1/2.
class SpeedForm {
  public:
    explicit SpeedForm(const PieceMotion& piece);

    /// Whether this is as good as the piece itself: all its weights are equal, its degree is so low that powers lose no
    /// digits, and its numbers have squares. All else needs that.
    bool is_plain() const { return count_ > 0; }

    /// Whether all velocities are known to lie within a right angle of one direction, so that none is against another.
    bool goes_onward() const { return goes_onward_; }

    Vector velocity(double s) const;
    double speed(double s) const { return length(velocity(s)); }

    /// The rules for the speed over an interval of s, as integrate_once has them.
    RulePair<double> rules(Interval interval) const;

  private:
    static constexpr std::size_t highest_degree = 8;

    std::size_t count_ = 0;
    std::array<Vector, highest_degree> powers_{};
    bool goes_onward_ = false;
};

}  // namespace batten::core
