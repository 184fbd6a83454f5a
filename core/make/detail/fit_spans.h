/// What the joints of fit points ask of the spans between them.
#pragma once

#include <optional>
#include <vector>

#include "core/make/fit_points.h"

namespace batten::core {

/// Whether the span after a point with this joint is a straight line.
constexpr bool is_straight(FitJoint joint) {
    return joint == FitJoint::straight || joint == FitJoint::corner_straight;
}

/// What holds at a point, where anything is given: the derivatives on both of its sides. What lies on one side then
/// does not depend on the other.
struct JointNeeds {
    bool is_break = false;   ///< the sides do not depend on each other
    bool is_corner = false;  ///< nor do they agree
    std::optional<Vector> left{};
    std::optional<Vector> right{};
};

/// The spans of valid fit points: one after each point, but for the last one of an open curve. Numbers of points may
/// run over the seam of a closed curve.
class FitSpans {
  public:
    explicit FitSpans(const FitPoints& fit) : fit_(fit) {}

    std::size_t point_count() const { return fit_.points.size(); }
    std::size_t count() const { return point_count() - (fit_.closed ? 0 : 1); }
    Point place(std::size_t i) const { return fit_.points[i % point_count()].place; }
    double length(std::size_t i) const {
        const std::size_t k = i % point_count();
        return fit_.parameters[k + 1] - fit_.parameters[k];
    }

    /// The derivative of the straight span after point `i`.
    Vector slope(std::size_t i) const { return (1.0 / length(i)) * (place(i + 1) - place(i)); }

    /// What holds at point `i`, below the count. The ends of an open curve are breaks.
    JointNeeds needs(std::size_t i) const;

  private:
    Vector local_derivative(std::size_t i) const;

    const FitPoints& fit_;
};

}  // namespace batten::core
