/// Random curves of every sort, the same in every run.
#pragma once

#include <random>

#include "core/curve/curve.h"

namespace batten::core {

/// A source of random numbers and curves with a fixed seed.
class RandomCurves {
  public:
    explicit RandomCurves(std::uint32_t seed) : engine_(seed) {}

    /// A number in [lower, upper).
    double number(double lower, double upper);

    /// A whole number in [lower, upper].
    int whole(int lower, int upper);

    /// A parameter of the domain, now and then exactly an end or a knot.
    double parameter(const Curve& curve);

    /// Degree 1 to 7, clamped or not, interior knots of multiplicity 1 to p, weights from 0.2 to 5.
    Curve open_curve();

    /// Degree 1 to 7 and 2 to 8 points, so also fewer points than the degree; knots and seam of multiplicity 1 to p.
    Curve periodic_curve();

    /// One or the other.
    Curve curve() { return whole(0, 2) == 0 ? periodic_curve() : open_curve(); }

  private:
    std::vector<double> knots(std::size_t count, int degree);
    Curve over(int degree, std::vector<double> knots, std::size_t point_count, bool periodic);

    std::mt19937 engine_;
};

}  // namespace batten::core
