/// The recurrence of the basis functions as data: the triangle from N_{i,0}, ..., N_{i+p,0} to N_{i,p}, and its ramps.
#pragma once

#include <optional>
#include <vector>

#include "core/curve/knot_vector.h"

namespace batten::core {

/// A straight line in u by which the recurrence multiplies a function, 0 at one end of its support and 1 at the other.
struct BasisRamp {
    double value = 0.0;    ///< at the parameter; beyond the support below 0 or above 1
    bool is_void = false;  ///< both ends are one knot: 0/0, which counts as 0, as does the function

    bool operator==(const BasisRamp&) const = default;
};

/// N_{i,k} = rising N_{i,k-1} + falling N_{i+1,k-1} at one parameter; for k = 0 the ramps have no meaning.
struct BasisCell {
    std::size_t index = 0;  ///< i
    double value = 0.0;     ///< 0 outside the support
    BasisRamp rising{};     ///< (u - u_i) / (u_{i+k} - u_i)
    BasisRamp falling{};    ///< (u_{i+k+1} - u) / (u_{i+k+1} - u_{i+1})
};

/// How N_{i,p} comes about at u.
struct BasisTriangle {
    double u = 0.0;
    /// levels[k][j] is N_{i+j,k}; level k has p + 1 - k cells, the last is N_{i,p}.
    std::vector<std::vector<BasisCell>> levels;

    double value() const { return levels.back().front().value; }
};

/// The span whose N_{s,0} is 1 at `u`, anywhere between the first knot and the last: u_s <= u < u_{s+1}, or
/// u_s < u <= u_{s+1} from the left. The ends of the domain and the last knot belong to the spans inside them. None
/// beyond the knots and for what is not a number.
std::optional<std::size_t> span_of_all(const KnotVector& knots, double u, Side side = Side::right);

/// The triangle of N_{i,p} at any finite `u`, also outside the domain, neither clamped nor wrapped; i + p + 1 must be
/// an index of `knots.values()`, the unrolled ones when periodic. Cost O(p^2 + log n). Source: Cox 1972; de Boor 1972;
/// The NURBS Book, 2.5.
BasisTriangle basis_triangle(const KnotVector& knots, std::size_t i, double u, Side side = Side::right);

/// N_{i,k}(u) alone, `k` from 0 to the degree, for the same `i` and `u`. Cost O(k^2 + log n).
double lower_basis_function(const KnotVector& knots, std::size_t i, int k, double u, Side side = Side::right);

}  // namespace batten::core
