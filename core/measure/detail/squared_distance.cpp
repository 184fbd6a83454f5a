#include "core/measure/detail/squared_distance.h"

#include <algorithm>
#include <cmath>

#include "core/base/detail/binomial.h"

namespace batten::core {

namespace {

// Of the sum of the sizes of its terms.
constexpr double rounding_share = 4.0 * std::numeric_limits<double>::epsilon();

// The coefficient k of the product of two polynomials of degree p, whose terms are product(i, k - i), which is
// symmetric.
template <class Product>
double coefficient_of_square(std::size_t k, std::size_t p, const ProductBinomials& binomials, const Product& product) {
    const std::size_t first = k > p ? k - p : 0;
    double sum = 0.0;
    std::size_t i = first;
    for (; 2 * i < k; ++i) sum += binomials.of_p[i] * binomials.of_p[k - i] * product(i, k - i);
    sum *= 2.0;
    if (2 * i == k) sum += binomials.of_p[i] * binomials.of_p[i] * product(i, i);
    return sum / binomials.of_2p[k];
}

// Counts changes of sign among the coefficients of a polynomial.
struct SignCounter {
    std::size_t degree;
    SquaredDistance::Slope slope{};
    double before = 0.0;
    double place_before = 0.0;

    explicit SignCounter(std::size_t n) : degree(n) {}

    void include(std::size_t k, Coefficient coefficient) {
        const double value = coefficient.value;
        if (!(std::abs(value) > coefficient.error)) return;
        const int sign = value < 0.0 ? -1 : 1;
        const double place = (static_cast<double>(k) + 0.5) / static_cast<double>(degree + 1);
        if (slope.first_sign == 0) slope.first_sign = sign;
        if (slope.last_sign == -sign) {
            ++slope.changes;
            slope.change = place_before + (place - place_before) * (before / (before - value));
        }
        slope.last_sign = sign;
        before = value;
        place_before = place;
    }
};

}  // namespace

ProductBinomials::ProductBinomials(std::size_t p) : of_p(binomials(p)), of_2p(binomials(2 * p)) {}

SquaredDistance::SquaredDistance(std::span<const HomogeneousPoint> points, bool is_rational,
                                 const ProductBinomials& binomials)
    : p_(points.size() - 1), is_rational_(is_rational) {
    for (std::size_t i = 0; i <= p_; ++i) weight_[i] = points[i].z;
    for (std::size_t k = 0; k <= 2 * p_; ++k) {
        distance_[k] = coefficient_of_square(k, p_, binomials, [&](std::size_t i, std::size_t j) {
            return points[i].x * points[j].x + points[i].y * points[j].y;
        });
        error_[k] = rounding_share * coefficient_of_square(k, p_, binomials, [&](std::size_t i, std::size_t j) {
                        return std::abs(points[i].x * points[j].x) + std::abs(points[i].y * points[j].y);
                    });
    }
    for (std::size_t k = 0; k <= 2 * p_; ++k)
        square_[k] = is_rational_
                         ? coefficient_of_square(k, p_, binomials,
                                                 [&](std::size_t i, std::size_t j) { return weight_[i] * weight_[j]; })
                         : 1.0;
}

bool SquaredDistance::is_nowhere_nearer(double radius) const {
    if (radius <= 0.0) return true;
    for (std::size_t k = 0; k <= 2 * p_; ++k)
        if (!(distance_[k] - error_[k] >= radius * radius * square_[k])) return false;
    return true;
}

bool SquaredDistance::is_nowhere_farther(double radius) const {
    for (std::size_t k = 0; k <= 2 * p_; ++k)
        if (!(distance_[k] + error_[k] <= radius * radius * square_[k])) return false;
    return true;
}

SquaredDistance::Slope SquaredDistance::slope(const ProductBinomials& binomials) const {
    SignCounter counter(is_rational_ ? 3 * p_ - 1 : 2 * p_ - 1);
    if (is_rational_)
        for (std::size_t k = 0; k < 3 * p_; ++k) counter.include(k, rational_slope(k, binomials));
    else
        for (std::size_t k = 0; k < 2 * p_; ++k)
            counter.include(k, {distance_[k + 1] - distance_[k], error_[k] + error_[k + 1]});
    return counter.slope;
}

// (N / w^2)' is (N' w - 2 N w') / w^3. Binomials are multiplied in, so that products are sums over k - i; signs stay.
Coefficient SquaredDistance::rational_slope(std::size_t k, const ProductBinomials& binomials) const {
    const std::size_t n = 2 * p_;
    Coefficient sum{0.0, 0.0};
    for (std::size_t i = k > p_ ? k - p_ : 0; i <= std::min(k, n - 1); ++i) {
        const double share = binomials.of_2p[i] * static_cast<double>(n - i) * binomials.of_p[k - i] * weight_[k - i];
        sum.value += share * (distance_[i + 1] - distance_[i]);
        sum.error += share * (error_[i] + error_[i + 1]);
    }
    for (std::size_t i = k > n ? k - n : 0; i <= std::min(k, p_ - 1); ++i) {
        const double share = 2.0 * binomials.of_p[i] * static_cast<double>(p_ - i) * binomials.of_2p[k - i];
        const double step = weight_[i + 1] - weight_[i];
        sum.value -= share * step * distance_[k - i];
        sum.error += share * (std::abs(step) * error_[k - i] + rounding_share * weight_[i] * distance_[k - i]);
    }
    return sum;
}

}  // namespace batten::core
