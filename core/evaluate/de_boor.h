/// The triangle of the de Boor algorithm as data: every point, weight and alpha, and the knots that make each alpha.
#pragma once

#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// One point P_i^r of the triangle. Level 0 holds control points, where alpha and its knots have no meaning.
struct DeBoorCell {
    std::size_t index = 0;  ///< i of P_i^r, in the numbering of the unrolled control points
    Point point{};
    double weight = 1.0;
    /// P_i^r = (1 - alpha) P_{i-1}^{r-1} + alpha P_i^{r-1}, in homogeneous coordinates.
    double alpha = 0.0;
    std::size_t lower_knot = 0;  ///< index i: alpha = (u - u_lower) / (u_upper - u_lower)
    std::size_t upper_knot = 0;  ///< index i + p - r + 1
};

/// The whole construction of C(u) from the p+1 control points of one span.
struct DeBoorTriangle {
    double u = 0.0;  ///< the parameter, brought into the domain
    std::size_t span = 0;
    /// levels[r][j] is P_i^r with i = span - p + r + j; level r has p + 1 - r cells, the last is C(u).
    std::vector<std::vector<DeBoorCell>> levels;

    Point point() const { return levels.back().front().point; }
};

/// The triangle at `u`, brought into the domain. Cost O(p^2). Source: The NURBS Book, section 5.2; de Boor 1972.
DeBoorTriangle de_boor_triangle(const Curve& curve, double u, Side side = Side::right);

/// The de Casteljau triangle of a Bézier curve, where every alpha is (u - a) / (b - a). Error:
/// curve_not_polynomial_piece unless both ends have multiplicity p+1 and there are no interior knots.
[[nodiscard]] Result<DeBoorTriangle> de_casteljau_triangle(const Curve& curve, double u);

}  // namespace batten::core
