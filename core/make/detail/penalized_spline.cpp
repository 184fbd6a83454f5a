#include "core/make/detail/penalized_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/detail/banded_least_squares.h"
#include "core/evaluate/basis.h"
#include "core/evaluate/basis_evaluator.h"

namespace batten::core {

namespace {

constexpr std::size_t degree = 3;

// The first and second derivative count a little, so that few samples suffice.
constexpr std::array shares_of_lower_orders{1e-13, 1e-8};

// In cross-validation the degrees of freedom count so often, errors below the other number a sample are not told apart,
// and the noise of a hand is independent only over so long a way. Source of the first: Kim and Gu 2004, Smoothing
// spline Gaussian regression.
constexpr double gamma = 1.4;
constexpr double least_error = 0.15;
constexpr double spacing = 5.0;

}  // namespace

PenalizedSpline::PenalizedSpline(const KnotVector& knots, std::span<const StrokeSample> samples, double span,
                                 const Stiffness& stiffness)
    : count_(knots.control_point_count()),
      is_ring_(knots.is_periodic()),
      normal_(count_, is_ring_ ? std::min(2 * degree, count_ - 1) : degree),
      penalty_(count_, normal_.width()),
      ridge_(count_, normal_.width()),
      right_x_(count_, 0.0),
      right_y_(count_, 0.0),
      way_(knots.domain().length()) {
    const BasisEvaluator basis(knots);
    std::array<double, degree + 1> row{};
    for (const StrokeSample& sample : samples) {
        const BasisValues values = basis.values_at(sample.station);
        std::copy_n(values.derivatives[0].begin(), degree + 1, row.begin());
        const std::size_t first = values.span - degree;
        add(normal_, first, row, sample.weight);
        for (std::size_t j = 0; j <= degree; ++j) {
            right_x_[unknown(first + j)] += sample.weight * row[j] * sample.place.x;
            right_y_[unknown(first + j)] += sample.weight * row[j] * sample.place.y;
        }
        square_sum_ += sample.weight * dot(sample.place, sample.place);
        weight_sum_ += sample.weight;
    }
    add_penalty(knots, span, stiffness);
}

void PenalizedSpline::add_penalty(const KnotVector& knots, double span, const Stiffness& stiffness) {
    std::array<double, degree + 1> row{};
    for (std::size_t s = degree; s + degree + 1 < knots.size(); ++s) {
        const double length = knots[s + 1] - knots[s];
        if (!(length > 0.0)) continue;
        const double middle = 0.5 * (knots[s] + knots[s + 1]);
        const BasisValues values = basis_functions(knots, middle, static_cast<int>(degree));
        const auto stretch = std::ranges::upper_bound(stiffness, middle, {}, &Stretch::end);
        const double share = length / span;
        double unit = 1.0;
        for (std::size_t order = 1; order <= degree; ++order) {
            unit *= span;
            for (std::size_t j = 0; j <= degree; ++j) row[j] = unit * values.derivatives[order][j];
            if (order < degree)
                add(ridge_, s - degree, row, shares_of_lower_orders[order - 1] * share);
            else
                add(penalty_, s - degree, row, share * (stretch == stiffness.end() ? 1.0 : stretch->factor));
        }
    }
}

std::size_t PenalizedSpline::unknown(std::size_t unrolled) const {
    return is_ring_ ? folded(unrolled % count_, count_) : unrolled;
}

void PenalizedSpline::add(SymmetricBand& matrix, std::size_t first, std::span<const double> row, double weight) const {
    for (std::size_t a = 0; a < row.size(); ++a)
        for (std::size_t b = 0; b < row.size(); ++b) {
            const std::size_t i = unknown(first + a);
            const std::size_t j = unknown(first + b);
            if (j <= i) matrix.at(i, j) += weight * row[a] * row[b];
        }
}

std::optional<std::vector<Vector>> PenalizedSpline::solved(const BandFactors& factors) const {
    if (!factors.is_definite()) return std::nullopt;
    std::vector<double> x = right_x_;
    std::vector<double> y = right_y_;
    factors.solve(x);
    factors.solve(y);
    std::vector<Vector> points(count_);
    for (std::size_t i = 0; i < count_; ++i) points[i] = {x[i], y[i]};
    return points;
}

std::optional<std::vector<Vector>> PenalizedSpline::solve(double lambda) const {
    const auto points = solved(BandFactors(normal_.plus(1.0, ridge_).plus(lambda, penalty_)));
    if (!points) return std::nullopt;
    std::vector<Vector> in_order(count_);
    for (std::size_t i = 0; i < count_; ++i) in_order[i] = (*points)[unknown(i)];
    return in_order;
}

double PenalizedSpline::score(double lambda) const {
    const BandFactors factors(normal_.plus(1.0, ridge_).plus(lambda, penalty_));
    const auto points = solved(factors);
    if (!points) return std::numeric_limits<double>::infinity();
    const double freedoms = factors.inverse().trace_of_product(normal_);
    const double independent = std::min(weight_sum_, way_ / spacing + 1.0);
    const double left = 1.0 - gamma * freedoms / independent;
    if (!(left > 0.0)) return std::numeric_limits<double>::infinity();
    std::vector<double> x(count_);
    std::vector<double> y(count_);
    for (std::size_t i = 0; i < count_; ++i) {
        x[i] = (*points)[i].x;
        y[i] = (*points)[i].y;
    }
    const std::vector<double> product_x = normal_.times(x);
    const std::vector<double> product_y = normal_.times(y);
    double errors = square_sum_ + weight_sum_ * 2.0 * least_error * least_error;
    for (std::size_t i = 0; i < count_; ++i)
        errors += x[i] * (product_x[i] - 2.0 * right_x_[i]) + y[i] * (product_y[i] - 2.0 * right_y_[i]);
    return std::max(errors, 0.0) / (left * left);
}

double PenalizedSpline::best_lambda() const {
    constexpr double least = -4.0;
    constexpr double most = 9.0;
    double best = 0.0;  // where there are too few samples to tell
    double best_score = std::numeric_limits<double>::infinity();
    const auto consider = [&](double exponent) {
        const double found = score(std::pow(10.0, exponent));
        if (found < best_score) {
            best_score = found;
            best = exponent;
        }
    };
    for (double exponent = most; exponent >= least; exponent -= 1.0) consider(exponent);
    const double middle = best;
    consider(middle + 0.5);
    consider(middle - 0.5);
    return std::pow(10.0, best);
}

}  // namespace batten::core
