/// From the derivatives of a homogeneous curve to those of its shadow.
#pragma once

#include "core/base/detail/binomial.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

/// A = w C and w at one parameter, with their derivatives of orders 1, 2, ...; those that are missing are zero.
struct HomogeneousJet {
    Vector point{};
    double weight = 1.0;
    ShortList<Vector, 3> derivatives{};
    ShortList<double, 3> weights{};
};

/// C', C'', ..., C^(order), by Leibniz's rule:
///     C^(k) = (A^(k) - sum_{i=1..k} binomial(k, i) w^(i) C^(k-i)) / w
/// Source: The NURBS Book, equation 4.8.
inline ShortList<Vector, 3> shadow_derivatives(const HomogeneousJet& seen, std::size_t order) {
    const Vector point = seen.point / seen.weight;
    ShortList<Vector, 3> derivatives;
    for (std::size_t k = 1; k <= order; ++k) {
        Vector sum = k <= seen.derivatives.size() ? seen.derivatives[k - 1] : Vector(0.0, 0.0);
        double binomial = 1.0;
        for (std::size_t i = 1; i <= std::min(k, seen.weights.size()); ++i) {
            binomial = next_binomial(binomial, k, i);
            sum -= binomial * seen.weights[i - 1] * (i < k ? derivatives[k - i - 1] : point);
        }
        derivatives.push_back(sum / seen.weight);
    }
    return derivatives;
}

}  // namespace batten::core
