#include "core/base/detail/symmetric_band.h"

#include <utility>

namespace batten::core {

double SymmetricBand::trace_of_product(const SymmetricBand& other) const {
    double on_diagonal = 0.0;
    double below = 0.0;
    for (std::size_t i = 0; i < size_; ++i) {
        on_diagonal += at(i, i) * other.at(i, i);
        for (std::size_t j = first_of(i); j < i; ++j) below += at(i, j) * other.at(i, j);
    }
    return on_diagonal + 2.0 * below;
}

std::vector<double> SymmetricBand::times(std::span<const double> vector) const {
    std::vector<double> product(size_, 0.0);
    for (std::size_t i = 0; i < size_; ++i) {
        product[i] += at(i, i) * vector[i];
        for (std::size_t j = first_of(i); j < i; ++j) {
            product[i] += at(i, j) * vector[j];
            product[j] += at(i, j) * vector[i];
        }
    }
    return product;
}

BandFactors::BandFactors(SymmetricBand matrix) : factors_(std::move(matrix)) {
    for (std::size_t i = 0; i < factors_.size() && is_definite_; ++i) {
        const std::size_t first = factors_.first_of(i);
        for (std::size_t j = first; j < i; ++j) {
            double sum = factors_.at(i, j);
            for (std::size_t k = std::max(first, factors_.first_of(j)); k < j; ++k)
                sum -= factors_.at(i, k) * factors_.at(j, k);
            // Row i holds L D until its diagonal is known.
            factors_.at(i, j) = sum;
        }
        double rest = factors_.at(i, i);
        for (std::size_t j = first; j < i; ++j) {
            const double with_diagonal = factors_.at(i, j);
            factors_.at(i, j) = with_diagonal / factors_.at(j, j);
            rest -= with_diagonal * factors_.at(i, j);
        }
        factors_.at(i, i) = rest;
        is_definite_ = rest > 0.0;
    }
}

void BandFactors::solve(std::span<double> right) const {
    assert(is_definite_ && right.size() == factors_.size());
    const std::size_t n = factors_.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = factors_.first_of(i); j < i; ++j) right[i] -= factors_.at(i, j) * right[j];
    for (std::size_t i = 0; i < n; ++i) right[i] /= factors_.at(i, i);
    for (std::size_t i = n; i-- > 0;)
        for (std::size_t j = factors_.first_of(i); j < i; ++j) right[j] -= factors_.at(i, j) * right[i];
}

SymmetricBand BandFactors::inverse() const {
    assert(is_definite_);
    const std::size_t n = factors_.size();
    SymmetricBand inverse(n, factors_.width());
    const auto entry = [&](std::size_t i, std::size_t j) -> double {
        return inverse.at(std::max(i, j), std::min(i, j));
    };
    for (std::size_t i = n; i-- > 0;) {
        const std::size_t end = std::min(n, i + factors_.width() + 1);
        for (std::size_t j = end; j-- > i;) {
            double sum = i == j ? 1.0 / factors_.at(i, i) : 0.0;
            for (std::size_t k = i + 1; k < end; ++k) sum -= factors_.at(k, i) * entry(k, j);
            inverse.at(j, i) = sum;
        }
    }
    return inverse;
}

}  // namespace batten::core
