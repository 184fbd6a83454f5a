/// Solves linear equations without any structure, square or overdetermined.
#pragma once

#include <vector>

#include "core/base/geometry.h"

namespace batten::core {

/// The equations sum_j matrix[i columns + j] x_j = right[i].
struct DenseEquations {
    std::size_t columns = 0;
    std::vector<double> matrix{};
    std::vector<HomogeneousPoint> right{};
};

/// The x with the least sum of squared errors, and of several such x the smallest. Cost O(m n^2) for m equations in n
/// unknowns. Source: Golub and Van Loan, Matrix Computations, 5.4.2.
std::vector<HomogeneousPoint> solve_least_squares(const DenseEquations& equations);

}  // namespace batten::core
