#include "exchange/json/homogeneous.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace batten::exchange {

double quotient_error(double x, double weight, double product) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double least = std::numeric_limits<double>::denorm_min();
    constexpr double rounding = 1.0 + 0x1p-50;
    if (!std::isfinite(x) || !std::isfinite(product)) return infinity;
    if (x == 0.0) return product == 0.0 ? 0.0 : std::max(std::abs(product / weight) * rounding, least);
    // Numbers near 1, so that the rest has all of its digits.
    int exponent_of_x = 0;
    int exponent_of_weight = 0;
    const double x_digits = std::frexp(x, &exponent_of_x);
    const double weight_digits = std::frexp(weight, &exponent_of_weight);
    const double rest =
        std::fma(x_digits, weight_digits, -std::ldexp(product, -exponent_of_x - exponent_of_weight)) / weight_digits;
    return rest == 0.0 ? 0.0 : std::max(std::ldexp(std::abs(rest) * rounding, exponent_of_x), least);
}

std::vector<double> weights_near_one(std::vector<double> weights) {
    constexpr int most_exponent = 64;
    if (weights.empty()) return weights;
    const int exponent = std::ilogb(*std::ranges::max_element(weights));
    if (std::abs(exponent) <= most_exponent) return weights;
    std::vector<double> scaled = weights;
    for (double& weight : scaled) weight = std::ldexp(weight, -exponent);
    const bool is_exact = std::ranges::equal(
        weights, scaled, [&](double before, double after) { return std::ldexp(after, exponent) == before; });
    return is_exact ? scaled : weights;
}

}  // namespace batten::exchange
