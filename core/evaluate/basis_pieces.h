/// The polynomials that a basis function consists of, one for each span of its support, in powers and in fractions.
#pragma once

#include <vector>

#include "core/base/fraction.h"
#include "core/curve/knot_vector.h"

namespace batten::core {

/// coefficients[0] + coefficients[1] x + ... + coefficients[k] x^k.
struct PowerForm {
    std::vector<double> coefficients;
    /// The same without rounding; empty for all pieces where a knot of the function is no small fraction, or a number
    /// on the way leaves 64 bits.
    std::vector<Fraction> fractions;
};

/// One polynomial piece.
struct BasisPiece {
    std::size_t span = 0;  ///< index s, u_s < u_{s+1}
    Interval interval;     ///< [u_s, u_{s+1}]
    PowerForm in_u;        ///< x is the parameter u itself
    PowerForm in_t;        ///< x is t = (u - u_s) / (u_{s+1} - u_s), from 0 to 1
};

/// The pieces of N_{i,k} over the non-empty spans of [u_i, u_{i+k+1}], in order, beyond the domain too; none where this
/// is one knot. `k` is from 0 to the degree; i + k + 1 must be an index of `knots.values()`, the unrolled ones when
/// periodic. Coefficients have the absolute accuracy of the largest one on the way: away from u = 0, and for a high
/// degree, in_u describes the function less well than in_t. Cost O(k^4). Source: the recurrence of Cox 1972 and de Boor
/// 1972 for polynomials.
std::vector<BasisPiece> basis_pieces(const KnotVector& knots, std::size_t i, int k);

}  // namespace batten::core
