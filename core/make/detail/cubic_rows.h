/// The equations of a cubic spline through points, many at once.
#pragma once

#include <array>
#include <cstddef>

namespace batten::core {

/// Rows of a band: row i is coefficients[0][i] times the unknown two before the diagonal, and so on to two after it.
struct CubicRows {
    static constexpr std::size_t capacity = 128;
    static constexpr std::size_t band = 2;
    using Numbers = std::array<double, capacity>;

    std::array<Numbers, 2 * band + 1> coefficients;
    Numbers x;  ///< the right side
    Numbers y;
};

/// What rows are made of: arrays that begin with what belongs to row 0.
struct CubicRowSource {
    const double* knots = nullptr;  ///< for row i read from knots[i-1] to knots[i+5]
    const double* sites = nullptr;  ///< sites[i] in [knots[i+1], knots[i+3]]
    const double* x = nullptr;      ///< of the point of each site; for row i read from x[i-2] to x[i+2]
    const double* y = nullptr;
};

/// Fills the rows from `begin` on before `end`: that the control points, each seen from the point of its site, make the
/// spline pass the points. The products of six distances of knots must be far from the least and the largest double.
void fill_cubic_rows(CubicRows& rows, const CubicRowSource& source, std::size_t begin, std::size_t end);

}  // namespace batten::core
