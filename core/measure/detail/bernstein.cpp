#include "core/measure/detail/bernstein.h"

#include <cassert>
#include <cmath>

#include "core/base/detail/binomial.h"
#include "core/curve/detail/bspline.h"

namespace batten::core {

namespace {

constexpr double unit_roundoff = 0.5 * std::numeric_limits<double>::epsilon();

// The relative error of a coefficient of a product: one rounding for each term and a few for its factors, the
// binomials of high degrees among them.
double product_rounding(std::size_t terms, std::size_t n) {
    return unit_roundoff * (static_cast<double>(terms) + 6.0 + 0.2 * static_cast<double>(n));
}

// De Casteljau's triangle at t: the coefficients of both sides. `a` becomes the right one.
std::vector<double> cut(std::vector<double>& a, Ratio ratio) {
    const std::size_t n = a.size() - 1;
    std::vector<double> left;
    left.reserve(n + 1);
    for (std::size_t level = 0; level <= n; ++level) {
        left.push_back(a.front());
        for (std::size_t i = 0; i + level < n; ++i) a[i] = blend(a[i], a[i + 1], ratio);
    }
    return left;
}

std::pair<Bernstein, Bernstein> cut(const Bernstein& a, Ratio ratio) {
    Bernstein right = a;
    Bernstein left;
    left.values = cut(right.values, ratio);
    left.errors = cut(right.errors, ratio);
    return {std::move(left), std::move(right)};
}

Bernstein elevated(const Bernstein& a, std::size_t degree) {
    if (a.degree() == degree) return a;
    if (a.degree() == 0) return {std::vector(degree + 1, a.values.front()), std::vector(degree + 1, a.errors.front())};
    const std::size_t by = degree - a.degree();
    return product(a, {std::vector(by + 1, 1.0), std::vector(by + 1, 0.0)});
}

}  // namespace

Bernstein constant(double value, double error) {
    return {{value}, {error}};
}

Bernstein product(const Bernstein& a, const Bernstein& b) {
    const std::size_t p = a.degree();
    const std::size_t q = b.degree();
    const auto of_a = binomials(p);
    const auto of_b = binomials(q);
    const auto of_product = binomials(p + q);
    Bernstein result{std::vector(p + q + 1, 0.0), std::vector(p + q + 1, 0.0)};
    for (std::size_t k = 0; k <= p + q; ++k) {
        const std::size_t first = k > q ? k - q : 0;
        const std::size_t last = std::min(k, p);
        double size = 0.0;
        double error = 0.0;
        for (std::size_t i = first; i <= last; ++i) {
            const double share = of_a[i] * of_b[k - i] / of_product[k];
            const double value = a.values[i] * b.values[k - i];
            result.values[k] += share * value;
            size += share * std::abs(value);
            error += share * (std::abs(a.values[i]) * b.errors[k - i] +
                              a.errors[i] * (std::abs(b.values[k - i]) + b.errors[k - i]));
        }
        result.errors[k] = error + product_rounding(last - first + 1, p + q) * size;
    }
    return result;
}

Bernstein sum(const Bernstein& a, const Bernstein& b) {
    const std::size_t degree = std::max(a.degree(), b.degree());
    Bernstein result = elevated(a, degree);
    const Bernstein other = elevated(b, degree);
    for (std::size_t k = 0; k <= degree; ++k) {
        result.values[k] += other.values[k];
        result.errors[k] += other.errors[k] + unit_roundoff * std::abs(result.values[k]);
    }
    return result;
}

Bernstein difference(const Bernstein& a, const Bernstein& b) {
    return sum(a, scaled(b, -1.0));
}

Bernstein scaled(Bernstein a, double factor) {
    for (double& value : a.values) value *= factor;
    for (double& error : a.errors) error *= std::abs(factor);
    return a;
}

Bernstein derivative(const Bernstein& a) {
    const std::size_t n = a.degree();
    if (n == 0) return constant(0.0);
    Bernstein result;
    for (std::size_t k = 0; k < n; ++k) {
        const double step = a.values[k + 1] - a.values[k];
        result.values.push_back(static_cast<double>(n) * step);
        result.errors.push_back(static_cast<double>(n) *
                                (a.errors[k] + a.errors[k + 1] + 2.0 * unit_roundoff * std::abs(step)));
    }
    return result;
}

double value_at(const Bernstein& a, double t) {
    std::vector<double> values = a.values;
    const Ratio ratio{1.0 - t, t};
    for (std::size_t level = 1; level < values.size(); ++level)
        for (std::size_t i = 0; i + level < values.size(); ++i) values[i] = blend(values[i], values[i + 1], ratio);
    return values.front();
}

std::pair<Bernstein, Bernstein> halves(const Bernstein& a) {
    return cut(a, {0.5, 0.5});
}

Bernstein part(const Bernstein& a, Interval interval) {
    assert(0.0 <= interval.lower && interval.lower < interval.upper && interval.upper <= 1.0);
    Bernstein rest = a;
    if (interval.lower > 0.0) rest = cut(rest, {1.0 - interval.lower, interval.lower}).second;
    if (interval.upper == 1.0) return rest;
    return cut(rest, ratio_between(interval.lower, 1.0, interval.upper)).first;
}

}  // namespace batten::core
