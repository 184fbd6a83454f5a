/// The velocity along a piece of low degree as a polynomial or a quotient of them, for quick quadrature.
#pragma once

#include <array>

#include "core/base/detail/quadrature.h"
#include "core/evaluate/detail/piece_motion.h"

namespace batten::core {

/// dC/dt by powers of the way from the middle of the piece, s = t - 1/2: its own, or where weights differ those of
/// numerator and denominator, seen from near the piece.
class SpeedForm {
  public:
    explicit SpeedForm(const PieceMotion& piece);

    /// Whether this is as good as the piece itself: its weights do not differ much, its degree is so low that powers
    /// lose no digits, and its numbers have squares. All else needs that.
    bool is_plain() const { return count_ > 0; }

    bool is_rational() const { return is_rational_; }

    /// Whether all velocities are known to lie within a right angle of one direction, so that none is against another.
    bool goes_onward() const { return goes_onward_; }

    Vector velocity(double s) const;
    double speed(double s) const { return length(velocity(s)); }

    /// The rules for the speed over an interval of s, as integrate_once has them.
    RulePair<double> rules(Interval interval) const;

  private:
    static constexpr std::size_t most_powers = 8;

    void take_polynomial(std::span<const HomogeneousPoint> points);
    void take_rational(std::span<const HomogeneousPoint> points);

    std::size_t count_ = 0;
    std::array<Vector, most_powers> powers_{};  // of the velocity, or of the numerator where there are weights
    std::array<double, most_powers> weight_powers_{};
    bool is_rational_ = false;
    bool goes_onward_ = false;
};

}  // namespace batten::core
