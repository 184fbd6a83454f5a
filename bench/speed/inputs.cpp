#include "inputs.h"

#include <cmath>
#include <random>

namespace batten::bench {

namespace {

// Uniform in [0, 1), the same with every standard library.
class Random {
  public:
    double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  private:
    std::mt19937_64 engine_{20};
};

}  // namespace

std::vector<core::Point> points_on_spiral(std::size_t count) {
    Random random;
    std::vector<core::Point> points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double turn = 0.3 * (static_cast<double>(i) + 0.5 * random());
        const double radius = 1.0 + 0.01 * turn + 0.1 * random();
        points.emplace_back(radius * std::cos(turn), radius * std::sin(turn));
    }
    return points;
}

core::Curve spiral(std::size_t n, int degree, bool is_rational) {
    Random random;
    const auto p = static_cast<std::size_t>(degree);
    std::vector<double> knots(n + p + 1, 0.0);
    for (std::size_t i = p + 1; i < knots.size(); ++i) knots[i] = knots[i - 1] + (i <= n ? 0.5 + random() : 0.0);
    const double length = knots[n];
    for (double& knot : knots) knot /= length;
    std::vector<double> weights;
    for (std::size_t i = 0; is_rational && i < n; ++i) weights.push_back(std::exp2(2.0 * random() - 1.0));
    return core::Curve::make({.degree = degree,
                              .knots = std::move(knots),
                              .points = points_on_spiral(n),
                              .weights = std::move(weights)})
        .value();
}

std::vector<double> sorted_parameters(std::size_t count) {
    std::vector<double> parameters(count);
    for (std::size_t i = 0; i < count; ++i) parameters[i] = static_cast<double>(i) / static_cast<double>(count - 1);
    return parameters;
}

std::vector<double> random_parameters(std::size_t count) {
    Random random;
    std::vector<double> parameters(count);
    for (double& u : parameters) u = random();
    return parameters;
}

}  // namespace batten::bench
