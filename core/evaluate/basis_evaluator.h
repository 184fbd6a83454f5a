/// Basis functions prepared for many parameters.
#pragma once

#include "core/evaluate/basis.h"
#include "core/evaluate/detail/interval_finder.h"

namespace batten::core {

/// Gives the values of basis_functions, up to rounding of 1, several times faster. Holds the polynomials of every span,
/// 8 bytes for each of (p+1)^2 + 5 numbers.
class BasisEvaluator {
  public:
    /// Cost O(n p^3).
    explicit BasisEvaluator(KnotVector knots);

    const KnotVector& knots() const { return knots_; }

    /// The functions that do not vanish at `u` (brought into the domain), seen from `side` at a knot: their values
    /// alone. Cost O(p^2); up to degree 7 nothing is taken from the heap.
    BasisValues values_at(double u, Side side = Side::right) const;

  private:
    void add(std::size_t s);

    KnotVector knots_;
    IntervalFinder spans_;
    std::vector<std::size_t> indices_;  // of each span
    // Of each span its middle, its scale (a power of two; zero where a sum would lose digits), and for each power of
    // t = scale (u - middle) the factor in each function.
    std::vector<double> numbers_;
};

}  // namespace batten::core
