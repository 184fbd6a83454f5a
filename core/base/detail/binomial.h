/// Binomial coefficients.
#pragma once

#include <vector>

namespace batten::core {

/// binomial(n, k) for k >= 1, where `previous` is binomial(n, k-1). Exact while it is below 2^53 / n.
constexpr double next_binomial(double previous, std::size_t n, std::size_t k) {
    return previous * static_cast<double>(n + 1 - k) / static_cast<double>(k);
}

/// binomial(n, 0), ..., binomial(n, n), symmetric to the last bit.
inline std::vector<double> binomials(std::size_t n) {
    std::vector<double> row(n + 1, 1.0);
    for (std::size_t k = 1; k <= n / 2; ++k) row[k] = row[n - k] = next_binomial(row[k - 1], n, k);
    return row;
}

}  // namespace batten::core
