#include "core/measure/detail/bernstein.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

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

// Long enough for products of most forms; longer ones are taken from the heap.
constexpr std::size_t known_binomials = 24;
using KnownBinomials = std::array<std::array<double, known_binomials + 1>, known_binomials + 1>;

constexpr KnownBinomials pascals_triangle() {
    KnownBinomials rows{};
    for (std::size_t n = 0; n <= known_binomials; ++n) {
        rows[n][0] = 1.0;
        for (std::size_t k = 1; k <= n; ++k) rows[n][k] = next_binomial(rows[n][k - 1], n, k);
    }
    return rows;
}

constexpr KnownBinomials binomial_rows = pascals_triangle();

// binomial(n, k) for all k.
class BinomialRow {
  public:
    explicit BinomialRow(std::size_t n)
        : computed_(n > known_binomials ? binomials(n) : std::vector<double>{}),
          row_(n > known_binomials ? computed_.data() : binomial_rows[n].data()) {}
    BinomialRow(const BinomialRow&) = delete;
    BinomialRow& operator=(const BinomialRow&) = delete;

    double operator[](std::size_t k) const { return row_[k]; }

  private:
    std::vector<double> computed_;
    const double* row_;
};

// De Casteljau's triangle at t: the coefficients of both sides. `a` becomes the right one.
void cut(Bernstein::Coefficients& a, Bernstein::Coefficients& left, Ratio ratio) {
    const std::size_t n = a.size() - 1;
    double* const right = a.begin();
    double* const out = left.begin();
    for (std::size_t level = 0; level <= n; ++level) {
        out[level] = right[0];
        for (std::size_t i = 0; i + level < n; ++i) right[i] = blend(right[i], right[i + 1], ratio);
    }
}

std::pair<Bernstein, Bernstein> cut(const Bernstein& a, Ratio ratio) {
    const std::size_t count = a.values.size();
    std::pair<Bernstein, Bernstein> both{{Bernstein::Coefficients(count), Bernstein::Coefficients(count)}, a};
    cut(both.second.values, both.first.values, ratio);
    cut(both.second.errors, both.first.errors, ratio);
    return both;
}

Bernstein times_constant(Bernstein a, const Bernstein& constant) {
    const double factor = constant.values.front();
    const double error = constant.errors.front();
    const double rounding = product_rounding(1, a.degree());
    for (std::size_t k = 0; k < a.values.size(); ++k) {
        const double size = std::abs(a.values[k]);
        a.errors[k] = std::abs(factor) * (a.errors[k] + rounding * size) + error * (size + a.errors[k]);
        a.values[k] *= factor;
    }
    return a;
}

// Coefficients times their binomials, so that products are convolutions.
struct ScaledForm {
    explicit ScaledForm(const Bernstein& a) : values(a.values), errors(a.errors) {
        const BinomialRow row(a.degree());
        for (std::size_t k = 0; k < values.size(); ++k) {
            values[k] *= row[k];
            errors[k] *= row[k];
        }
    }

    Bernstein::Coefficients values;
    Bernstein::Coefficients errors;
};

}  // namespace

Bernstein constant(double value, double error) {
    return {{value}, {error}};
}

Bernstein product(const Bernstein& a, const Bernstein& b) {
    const std::size_t p = a.degree();
    const std::size_t q = b.degree();
    if (p == 0) return times_constant(b, a);
    if (q == 0) return times_constant(a, b);
    const ScaledForm of_a(a);
    const ScaledForm of_b(b);
    Bernstein result{Bernstein::Coefficients(p + q + 1, 0.0), Bernstein::Coefficients(p + q + 1, 0.0)};
    Bernstein::Coefficients sizes(p + q + 1, 0.0);
    for (std::size_t i = 0; i <= p; ++i) {
        const double value = of_a.values.begin()[i];
        const double error = of_a.errors.begin()[i];
        const double* const values = of_b.values.begin();
        const double* const errors = of_b.errors.begin();
        double* const to = result.values.begin() + i;
        double* const to_error = result.errors.begin() + i;
        double* const to_size = sizes.begin() + i;
        for (std::size_t j = 0; j <= q; ++j) {
            to[j] += value * values[j];
            to_size[j] += std::abs(value * values[j]);
            to_error[j] += std::abs(value) * errors[j] + error * (std::abs(values[j]) + errors[j]);
        }
    }
    const BinomialRow row(p + q);
    const double rounding = product_rounding(std::min(p, q) + 1, p + q);
    double* const to = result.values.begin();
    double* const to_error = result.errors.begin();
    const double* const of_size = sizes.begin();
    for (std::size_t k = 0; k <= p + q; ++k) {
        to[k] /= row[k];
        to_error[k] = (to_error[k] + rounding * of_size[k]) / row[k];
    }
    return result;
}

Bernstein elevated(const Bernstein& a, std::size_t degree) {
    if (a.degree() == degree) return a;
    if (a.degree() == 0)
        return {Bernstein::Coefficients(degree + 1, a.values.front()),
                Bernstein::Coefficients(degree + 1, a.errors.front())};
    const std::size_t by = degree - a.degree();
    return product(a, {Bernstein::Coefficients(by + 1, 1.0), Bernstein::Coefficients(by + 1, 0.0)});
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
    Bernstein result{Bernstein::Coefficients(n), Bernstein::Coefficients(n)};
    for (std::size_t k = 0; k < n; ++k) {
        const double step = a.values[k + 1] - a.values[k];
        result.values[k] = static_cast<double>(n) * step;
        result.errors[k] =
            static_cast<double>(n) * (a.errors[k] + a.errors[k + 1] + 2.0 * unit_roundoff * std::abs(step));
    }
    return result;
}

double value_at(const Bernstein& a, double t) {
    Bernstein::Coefficients values = a.values;
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
