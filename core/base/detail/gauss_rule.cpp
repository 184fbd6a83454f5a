#include "core/base/detail/gauss_rule.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace batten::core {

namespace {

struct Legendre {
    double value = 0.0;
    double derivative = 0.0;
};

Legendre legendre(std::size_t degree, double x) {
    double before = 1.0;
    double value = x;
    for (std::size_t k = 2; k <= degree; ++k) {
        const auto n = static_cast<double>(k);
        const double next = ((2.0 * n - 1.0) * x * value - (n - 1.0) * before) / n;
        before = value;
        value = next;
    }
    return {value, static_cast<double>(degree) * (x * value - before) / (x * x - 1.0)};
}

}  // namespace

std::vector<GaussNode> gauss_rule(std::size_t count) {
    assert(count >= 1);
    constexpr int newton_steps = 8;
    std::vector<GaussNode> nodes(count);
    for (std::size_t i = 0; 2 * i < count; ++i) {
        double x = -std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (static_cast<double>(count) + 0.5));
        if (2 * i + 1 == count) x = 0.0;
        for (int k = 0; k < newton_steps; ++k) {
            const Legendre at = legendre(count, x);
            x -= at.value / at.derivative;
        }
        const double slope = legendre(count, x).derivative;
        const double weight = 2.0 / ((1.0 - x * x) * slope * slope);
        nodes[i] = {x, weight};
        nodes[count - 1 - i] = {-x, weight};
    }
    return nodes;
}

}  // namespace batten::core
