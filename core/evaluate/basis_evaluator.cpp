#include "core/evaluate/basis_evaluator.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/curve/detail/known_degree.h"

namespace batten::core {

namespace {

// Up to this sum of terms little more than the last digit of a value is lost.
constexpr double largest_sum = 3.0;

// Powers of two of a larger order may be no doubles.
constexpr double largest_order = 900.0;

std::vector<double> joints_of(const KnotVector& knots) {
    const auto p = static_cast<std::size_t>(knots.degree());
    const auto inner = knots.values().subspan(p, knots.size() - 2 * p);
    std::vector<double> joints(inner.begin(), inner.end());
    joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
    return joints;
}

template <class Degree>
void set_row(BasisRow& row, const double* factors, Degree p, double t) {
    std::array<double, most_local_points<Degree>> sums{};
    for (std::size_t k = p + 1; k-- > 0;)
        for (std::size_t j = 0; j <= p; ++j) sums[j] = sums[j] * t + factors[k * (p + 1) + j];
    row.assign(std::span<const double>(sums).first(p + 1));
}

}  // namespace

BasisEvaluator::BasisEvaluator(KnotVector knots) : knots_(std::move(knots)), spans_(joints_of(knots_)) {
    const auto p = static_cast<std::size_t>(knots_.degree());
    for (std::size_t s = p; s + p + 1 < knots_.size(); ++s)
        if (knots_[s] < knots_[s + 1]) add(s);
}

void BasisEvaluator::add(std::size_t s) {
    const double reach = 0.5 * (knots_[s + 1] - knots_[s]);
    const double middle = knots_[s] + reach;
    const int order = std::ilogb(reach) + 1;
    const BasisValues basis = basis_functions(knots_, middle, knots_.degree());
    indices_.push_back(s);
    numbers_.push_back(middle);
    numbers_.push_back(std::ldexp(1.0, -order));
    const std::size_t at_scale = numbers_.size() - 1;
    double factor = 1.0;
    double sum = 0.0;
    for (std::size_t k = 0; k < basis.derivatives.size(); ++k) {
        if (k > 0) factor *= std::ldexp(1.0, order) / static_cast<double>(k);
        double largest = 0.0;
        for (const double value : basis.derivatives[k]) {
            numbers_.push_back(factor * value);
            largest = std::max(largest, std::abs(factor * value));
        }
        sum += largest;
    }
    const bool is_sharp = sum <= largest_sum && std::abs(static_cast<double>(order)) * knots_.degree() < largest_order;
    if (!is_sharp || basis.span != s) numbers_[at_scale] = 0.0;
}

BasisValues BasisEvaluator::values_at(double u, Side side) const {
    const double inside = spans_.has_inside(u) ? u : knots_.into_domain(u, side);
    if (!spans_.has_inside(inside)) return basis_functions(knots_, u, 0, side);
    const std::size_t i = spans_.interval_at(inside, side);
    const auto degree = static_cast<std::size_t>(knots_.degree());
    const double* numbers = numbers_.data() + i * (2 + (degree + 1) * (degree + 1));
    const double middle = numbers[0];
    const double scale = numbers[1];
    if (scale == 0.0) return basis_functions(knots_, inside, 0, side);
    BasisValues values{.span = indices_[i], .derivatives = ShortList<BasisRow, 1>(1)};
    with_known_degree(degree,
                      [&](auto p) { set_row(values.derivatives[0], numbers + 2, p, scale * (inside - middle)); });
    return values;
}

}  // namespace batten::core
