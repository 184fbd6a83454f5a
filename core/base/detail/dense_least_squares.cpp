#include "core/base/detail/dense_least_squares.h"

#include <Eigen/QR>
#include <cassert>

namespace batten::core {

std::vector<HomogeneousPoint> solve_least_squares(const DenseEquations& equations) {
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto columns = static_cast<Eigen::Index>(equations.columns);
    const auto rows = static_cast<Eigen::Index>(equations.right.size());
    assert(rows * columns == static_cast<Eigen::Index>(equations.matrix.size()));
    Eigen::MatrixXd right(rows, 3);
    for (Eigen::Index i = 0; i < rows; ++i)
        for (int axis = 0; axis < 3; ++axis) right(i, axis) = equations.right[static_cast<std::size_t>(i)][axis];
    const Eigen::MatrixXd matrix = Eigen::Map<const Matrix>(equations.matrix.data(), rows, columns);
    const Eigen::MatrixXd solution = matrix.completeOrthogonalDecomposition().solve(right);
    std::vector<HomogeneousPoint> x;
    for (Eigen::Index j = 0; j < columns; ++j) x.emplace_back(solution(j, 0), solution(j, 1), solution(j, 2));
    return x;
}

}  // namespace batten::core
