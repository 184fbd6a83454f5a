/// The squared distance between a Bézier piece and a point, in Bernstein form.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/curve/detail/bspline.h"

namespace batten::core {

/// What products of polynomials of degree p need, once for many.
struct ProductBinomials {
    std::vector<double> of_p;
    std::vector<double> of_2p;

    explicit ProductBinomials(std::size_t p);
};

/// A coefficient and how far rounding may have moved it.
struct Coefficient {
    double value = 0.0;
    double error = 0.0;
};

/// |C(t) - Q|^2 = N(t) / w(t)^2 of a piece, t from 0 to 1. On the stack, however high the degree.
class SquaredDistance {
  public:
    /// Of the homogeneous points (x, y, w) of a piece, seen from Q; w = 1 for all of them unless `is_rational`.
    /// Cost O(p^2).
    SquaredDistance(std::span<const HomogeneousPoint> points, bool is_rational, const ProductBinomials& binomials);

    /// Whether the Bernstein form proves, for all that rounding may do, that no point is nearer than `radius`, or none
    /// farther.
    bool is_nowhere_nearer(double radius) const;
    bool is_nowhere_farther(double radius) const;

    /// The signs of the Bernstein coefficients of the slope, but for what rounding may have made of zero: none is 0.
    struct Slope {
        int first_sign = 0;
        int last_sign = 0;
        int changes = 0;
        double change = 0.0;  ///< about where the last one is, from 0 to 1
    };

    /// Cost O(p), for rational pieces O(p^2).
    Slope slope(const ProductBinomials& binomials) const;

  private:
    using Coefficients = std::array<double, 2 * max_degree + 1>;

    Coefficient rational_slope(std::size_t k, const ProductBinomials& binomials) const;

    std::size_t p_;
    bool is_rational_;
    Coefficients distance_;  ///< N
    Coefficients error_;     ///< how far each of them may be off
    Coefficients square_;    ///< w^2
    LocalPoints<double> weight_;
};

}  // namespace batten::core
