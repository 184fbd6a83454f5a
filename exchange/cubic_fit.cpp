#include "exchange/cubic_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/evaluate/evaluate.h"
#include "core/evaluate/tangent.h"

namespace batten::exchange {

namespace {

using Cubic = std::array<core::Point, 4>;

// Handles along the tangents such that the cubic passes the middle of the curve; none where they would point back or
// lead far beyond the ends.
std::optional<Cubic> through_middle(const core::Curve& curve, core::Point first, core::Point last) {
    const core::Interval domain = curve.domain();
    const auto leaving = core::tangent_at(curve, domain.lower, core::Side::right);
    const auto arriving = core::tangent_at(curve, domain.upper, core::Side::left);
    if (!leaving || !arriving) return std::nullopt;
    const core::Point middle = core::point_at(curve, domain.lower + 0.5 * (domain.upper - domain.lower));
    const core::Vector wanted = 8.0 / 3.0 * (middle - core::middle(first, last));
    const double area = core::cross(*leaving, *arriving);
    const double a = core::cross(wanted, *arriving) / area;
    const double b = core::cross(wanted, *leaving) / area;
    const double most = 4.0 * (core::robust_length(middle - first) + core::robust_length(last - middle));
    const auto is_usable = [most](double handle) { return handle >= 0.0 && handle <= most; };
    if (!is_usable(a) || !is_usable(b)) return std::nullopt;
    return Cubic{first, first + a * *leaving, last - b * *arriving, last};
}

// The cubic with the same points and derivatives at its ends.
Cubic with_end_derivatives(const core::Curve& curve, core::Point first, core::Point last) {
    const core::Interval domain = curve.domain();
    const double third = (domain.upper - domain.lower) / 3.0;
    const auto handle = [&](double u, core::Side side) {
        return third * core::derivatives_at(curve, u, 1, side).derivatives.front();
    };
    return {first, first + handle(domain.lower, core::Side::right), last - handle(domain.upper, core::Side::left),
            last};
}

bool all_finite(const Cubic& cubic) {
    return std::ranges::all_of(cubic, [](core::Point point) { return core::is_finite(point); });
}

struct Guess {
    Cubic cubic{};
    // Bernstein coefficients of the parameter of the cubic, over that of the curve in [0, 1].
    std::array<double, 5> parameter{0.0, 0.25, 0.5, 0.75, 1.0};
};

// The cubic passes the middle of the curve at its own middle and leaves and arrives with other speeds; a parameter of
// degree 4 makes them those of the curve.
std::array<double, 5> matched_parameter(const core::Curve& curve, const Cubic& cubic) {
    const Cubic same_speed = with_end_derivatives(curve, cubic[0], cubic[3]);
    const auto ratio = [&](std::size_t end, std::size_t handle) {
        return core::robust_length(same_speed[handle] - cubic[end]) / core::robust_length(cubic[handle] - cubic[end]);
    };
    const double second = 0.25 * ratio(0, 1);
    const double fourth = 1.0 - 0.25 * ratio(3, 2);
    const std::array<double, 5> wanted{0.0, second, (7.0 - 4.0 * (second + fourth)) / 6.0, fourth, 1.0};
    const bool is_usable = std::ranges::all_of(wanted, [](double value) { return 0.0 <= value && value <= 1.0; });
    return is_usable ? wanted : Guess{}.parameter;
}

// With the tangents of the curve, and few pieces where it is smooth.
std::optional<Guess> smooth_guess(const core::Curve& curve) {
    const auto cubic = through_middle(curve, curve.control_points().front(), curve.control_points().back());
    if (!cubic || !all_finite(*cubic)) return std::nullopt;
    return Guess{*cubic, matched_parameter(curve, *cubic)};
}

// With the derivatives of the curve, which it nears by every halving, also around a cusp.
Guess plain_guess(const core::Curve& curve) {
    const core::Point first = curve.control_points().front();
    const core::Point last = curve.control_points().back();
    if (const Cubic cubic = with_end_derivatives(curve, first, last); all_finite(cubic)) return {cubic};
    return {{first, first, last, last}};
}

// The binomial coefficients of n.
std::vector<double> choices_of(std::size_t n) {
    std::vector<double> choices(n + 1, 1.0);
    for (std::size_t i = 0; i < n; ++i)
        choices[i + 1] = choices[i] * static_cast<double>(n - i) / static_cast<double>(i + 1);
    return choices;
}

// The product of two polynomials in Bernstein form.
std::vector<double> product(std::span<const double> a, std::span<const double> b) {
    const auto of_a = choices_of(a.size() - 1);
    const auto of_b = choices_of(b.size() - 1);
    const auto of_both = choices_of(a.size() + b.size() - 2);
    std::vector<double> result(of_both.size(), 0.0);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += of_a[i] * a[i] * of_b[j] * b[j];
    for (std::size_t k = 0; k < result.size(); ++k) result[k] /= of_both[k];
    return result;
}

// The control points of D(phi(t)), of degree 12, seen from the first one.
std::vector<core::Vector> composed(const Guess& guess) {
    const std::span<const double> phi = guess.parameter;
    std::array<double, 5> rest{};
    std::ranges::transform(phi, rest.begin(), [](double value) { return 1.0 - value; });
    std::vector<core::Vector> result(13, {0.0, 0.0});
    const auto add = [&](double factor, std::span<const double> a, std::span<const double> b, std::span<const double> c,
                         core::Vector v) {
        const std::vector<double> share = product(product(a, b), c);
        for (std::size_t k = 0; k < result.size(); ++k) result[k] += factor * share[k] * v;
    };
    const Cubic& points = guess.cubic;
    add(3.0, phi, rest, rest, points[1] - points[0]);
    add(3.0, phi, phi, rest, points[2] - points[0]);
    add(1.0, phi, phi, phi, points[3] - points[0]);
    return result;
}

// The weighted difference w(t) (C(t) - D(phi(t))) and w(t) as one polynomial in Bernstein form.
std::vector<core::HomogeneousPoint> difference(const core::Curve& curve, const Guess& guess) {
    const auto points = curve.control_points();
    const std::vector<core::Vector> others = composed(guess);
    const auto of_curve = choices_of(points.size() - 1);
    const auto of_others = choices_of(others.size() - 1);
    const auto of_both = choices_of(points.size() + others.size() - 2);
    const double heaviest = std::ranges::max(curve.weights());
    std::vector<core::HomogeneousPoint> result(of_both.size(), core::HomogeneousPoint(0.0, 0.0, 0.0));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const core::Vector place = points[i] - points[0];
        for (std::size_t j = 0; j < others.size(); ++j) {
            const double weight = of_curve[i] * of_others[j] / of_both[i + j] * (curve.weights()[i] / heaviest);
            const core::Vector v = weight * (place - others[j]);
            result[i + j] += core::HomogeneousPoint(v.x, v.y, weight);
        }
    }
    return result;
}

// No quotient is longer than those of the coefficients, of which there are nearer ones in both halves. Infinite where
// one of them is beyond doubles.
double length_bound(std::vector<core::HomogeneousPoint> coefficients, double wanted, int halvings) {
    double bound = 0.0;
    for (const core::HomogeneousPoint& c : coefficients) {
        const double here = core::robust_length(core::Vector(c.x / c.z, c.y / c.z));
        if (!std::isfinite(here)) return std::numeric_limits<double>::infinity();
        bound = std::max(bound, here);
    }
    if (bound <= wanted || halvings == 0) return bound;
    std::vector<core::HomogeneousPoint> left;
    for (std::size_t k = coefficients.size(); k > 0; --k) {
        left.push_back(coefficients.front());
        for (std::size_t i = 0; i + 1 < k; ++i) coefficients[i] = 0.5 * (coefficients[i] + coefficients[i + 1]);
    }
    return std::max(length_bound(std::move(left), wanted, halvings - 1),
                    length_bound(std::move(coefficients), wanted, halvings - 1));
}

// What the bound may be short of by the rounding of its own steps, each half an epsilon of what it is taken of. All
// points are seen from the first one, so that none is larger than `size` and no difference than twice that; all shares
// are positive and sum to 1, so that no step makes the rounding before it larger. Composing takes 28 steps, the
// differences 6 for a term and 13 for their sum, two halvings 37 each for the degree 12 + 25; the weights, by which is
// divided, 4, 13 and 37 twice; a quotient and its length 3.
double rounding_of_bound(const core::Curve& curve, const Guess& guess) {
    constexpr double steps = 220.0;
    double size = 0.0;
    const auto see = [&](core::Point point) {
        size = std::max(size, core::robust_length(point - curve.control_points().front()));
    };
    std::ranges::for_each(curve.control_points(), see);
    std::ranges::for_each(guess.cubic, see);
    return steps * 0.5 * std::numeric_limits<double>::epsilon() * 2.0 * size;
}

CubicFit fit_of(const core::Curve& curve, const Guess& guess, double wanted) {
    constexpr int halvings = 2;
    const double rounding = rounding_of_bound(curve, guess);
    return {guess.cubic, length_bound(difference(curve, guess), wanted - rounding, halvings) + rounding};
}

}  // namespace

CubicFit cubic_fit(const core::Curve& piece, double wanted) {
    const std::optional<Guess> smooth = smooth_guess(piece);
    if (!smooth) return fit_of(piece, plain_guess(piece), wanted);
    const CubicFit fit = fit_of(piece, *smooth, wanted);
    if (fit.error <= wanted) return fit;
    const CubicFit plain = fit_of(piece, plain_guess(piece), wanted);
    return plain.error < fit.error ? plain : fit;
}

// The parameter t / (t + 2^k (1 - t)) multiplies the weight i by 2^(k i), but for a common factor.
core::Curve with_even_ends(const core::Curve& piece) {
    const auto weights = piece.weights();
    const std::size_t p = weights.size() - 1;
    const double ratio = std::log2(weights.front()) - std::log2(weights.back());
    const int k = static_cast<int>(std::lround(ratio / static_cast<double>(p)));
    int heaviest = std::numeric_limits<int>::min();
    for (std::size_t i = 0; i <= p; ++i)
        heaviest = std::max(heaviest, std::ilogb(weights[i]) + k * static_cast<int>(i));
    core::CurveDefinition definition{.degree = static_cast<int>(p),
                                     .points = {piece.control_points().begin(), piece.control_points().end()}};
    for (std::size_t i = 0; i <= p; ++i) {
        definition.weights.push_back(std::scalbn(weights[i], k * static_cast<int>(i) - heaviest));
        if (!std::isnormal(definition.weights.back())) return piece;
    }
    definition.knots.assign(p + 1, 0.0);
    definition.knots.insert(definition.knots.end(), p + 1, 1.0);
    return core::Curve::make(std::move(definition)).value_or(piece);
}

}  // namespace batten::exchange
