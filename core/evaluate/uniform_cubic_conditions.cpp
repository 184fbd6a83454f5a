#include "core/evaluate/uniform_cubic_conditions.h"

#include <cassert>
#include <numeric>

#include "core/evaluate/uniform_cubic.h"

namespace batten::core {

namespace {

Fraction sixths(int count) {
    const int common = std::gcd(count, 6);
    return {count / common, 6 / common};
}

// k (k - 1) ..., `order` factors: of t^k, what its derivative is at t = 1.
int falling(int k, int order) {
    return order == 0 ? 1 : k * falling(k - 1, order - 1);
}

Fraction derivative_at_start(std::size_t j, int order) {
    return sixths(falling(order, order) * uniform_cubic_matrix[static_cast<std::size_t>(order)][j]);
}

Fraction derivative_at_end(std::size_t j, int order) {
    int sum = 0;
    for (int k = 0; k < 4; ++k) sum += falling(k, order) * uniform_cubic_matrix[static_cast<std::size_t>(k)][j];
    return sixths(sum);
}

UniformCubicCondition condition(std::size_t joint, int order) {
    UniformCubicCondition made{.joint = joint, .order = order};
    if (joint > 0) made.before = 4 - joint;
    if (joint < 4) made.after = 3 - joint;
    if (made.before) made.left = derivative_at_end(*made.before, order);
    if (made.after) made.right = derivative_at_start(*made.after, order);
    return made;
}

}  // namespace

std::array<Fraction, 4> uniform_cubic_piece(std::size_t j) {
    assert(j < 4);
    std::array<Fraction, 4> coefficients;
    for (std::size_t k = 0; k < 4; ++k) coefficients[k] = sixths(uniform_cubic_matrix[k][j]);
    return coefficients;
}

double uniform_cubic_value(std::size_t j, double t) {
    assert(j < 4);
    double sum = 0.0;
    for (std::size_t k = 4; k-- > 0;) sum = sum * t + uniform_cubic_matrix[k][j];
    return sum / 6.0;
}

std::array<UniformCubicCondition, 15> uniform_cubic_conditions() {
    std::array<UniformCubicCondition, 15> conditions;
    for (std::size_t i = 0; i < conditions.size(); ++i) conditions[i] = condition(i / 3, static_cast<int>(i % 3));
    return conditions;
}

std::array<Fraction, 4> uniform_cubic_sum() {
    std::array<Fraction, 4> sum;
    for (std::size_t k = 0; k < 4; ++k)
        sum[k] = sixths(std::accumulate(uniform_cubic_matrix[k].begin(), uniform_cubic_matrix[k].end(), 0));
    return sum;
}

}  // namespace batten::core
