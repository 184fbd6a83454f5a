#include "core/evaluate/rational_basis.h"

#include <cassert>
#include <utility>

#include "core/base/detail/binomial.h"

namespace batten::core {

namespace {

// By Leibniz's rule for w R_j = N_j w_j, where w is the sum of all N_j w_j:
//     R_j^(k) = (N_j^(k) w_j - sum_{i=1..k} binomial(k, i) w^(i) R_j^(k-i)) / w
void make_rational(ShortList<BasisRow, 1>& derivatives, const std::vector<double>& weights) {
    std::vector<double> sums;
    for (BasisRow& row : derivatives) {
        double sum = 0.0;
        for (std::size_t j = 0; j < row.size(); ++j) {
            row[j] *= weights[j];
            sum += row[j];
        }
        sums.push_back(sum);
    }
    for (std::size_t k = 0; k < derivatives.size(); ++k)
        for (std::size_t j = 0; j < weights.size(); ++j) {
            double& value = derivatives[k][j];
            double binomial = 1.0;
            for (std::size_t i = 1; i <= k; ++i) {
                binomial = next_binomial(binomial, k, i);
                value -= binomial * sums[i] * derivatives[k - i][j];
            }
            value /= sums[0];
        }
}

}  // namespace

RationalBasis rational_basis(const Curve& curve, double u, int order, Side side) {
    assert(order >= 0);
    BasisValues basis = basis_functions(curve.knots(), u, order, side);
    RationalBasis result{basis.span - static_cast<std::size_t>(curve.degree()), std::move(basis.derivatives)};
    if (!curve.is_rational()) return result;
    std::vector<double> weights;
    for (std::size_t j = 0; j < result.derivatives[0].size(); ++j)
        weights.push_back(curve.weights()[(result.first + j) % curve.weights().size()]);
    make_rational(result.derivatives, weights);
    return result;
}

}  // namespace batten::core
