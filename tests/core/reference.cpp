#include "tests/core/reference.h"

#include <cmath>

#include "tests/core/golden.h"

namespace batten::core::reference {

namespace {

std::vector<double> unrolled(const Curve& curve) {
    const auto stored = curve.knots().stored();
    if (!curve.is_periodic()) return {stored.begin(), stored.end()};
    const auto p = curve.degree();
    const auto n = static_cast<int>(stored.size()) - 1;
    std::vector<double> knots;
    for (int k = -p; k <= n + p; ++k) {
        const int turn = static_cast<int>(std::floor(static_cast<double>(k) / n));
        knots.push_back(stored[static_cast<std::size_t>(k - turn * n)] + turn * (stored.back() - stored.front()));
    }
    return knots;
}

}  // namespace

long double basis_function(std::span<const double> knots, std::size_t p, std::size_t i, std::size_t span,
                           long double u) {
    if (p == 0) return i == span ? 1.0L : 0.0L;
    long double sum = 0.0L;
    if (knots[i + p] > knots[i])
        sum += (u - knots[i]) / (static_cast<long double>(knots[i + p]) - knots[i]) *
               basis_function(knots, p - 1, i, span, u);
    if (knots[i + p + 1] > knots[i + 1])
        sum += (knots[i + p + 1] - u) / (static_cast<long double>(knots[i + p + 1]) - knots[i + 1]) *
               basis_function(knots, p - 1, i + 1, span, u);
    return sum;
}

Point point_at(const Curve& curve, double u) {
    const auto knots = unrolled(curve);
    const auto p = static_cast<std::size_t>(curve.degree());
    std::size_t span = p;
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s)
        if (knots[s] < knots[s + 1] && knots[s] <= u) span = s;
    long double x = 0.0L;
    long double y = 0.0L;
    long double w = 0.0L;
    for (std::size_t i = span - p; i <= span; ++i) {
        const std::size_t k = i % curve.control_points().size();
        const long double share = basis_function(knots, p, i, span, u) * curve.weights()[k];
        x += share * curve.control_points()[k].x;
        y += share * curve.control_points()[k].y;
        w += share;
    }
    return {static_cast<double>(x / w), static_cast<double>(y / w)};
}

double relative_distance(const Curve& curve, Point a, Point b) {
    return std::hypot(a.x - b.x, a.y - b.y) / golden::largest_coordinate(curve.control_points());
}

}  // namespace batten::core::reference
