#include "core/measure/detail/speed_form.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/detail/binomial.h"
#include "core/base/detail/vectorized.h"
#include "core/base/double_double.h"
#include "core/curve/detail/known_degree.h"

namespace batten::core {

namespace {

// Numbers of sizes that have squares without over- or underflow.
constexpr Interval squared_well{1e-140, 1e140};

// Weights that differ by less leave the quotient its digits.
constexpr double most_weight_ratio = 16.0;

constexpr std::size_t node_count = 2 * gauss_kronrod::nodes.size();

using NodeValues = std::array<double, node_count>;

// The speeds at all nodes, pair by pair; unrolled where the count is known. Arrays are pointers here, because what is
// compiled for one kind of processor calls no function that is compiled for all.
template <class Count>
[[gnu::always_inline]] inline void fill_speeds_of(const Vector* powers, Count count, const double* places,
                                                  double* speeds) {
    BATTEN_INDEPENDENT
    for (std::size_t i = 0; i < node_count; ++i) {
        double x = powers[count - 1].x;
        double y = powers[count - 1].y;
        for (std::size_t k = count - 1; k-- > 0;) {
            x = x * places[i] + powers[k].x;
            y = y * places[i] + powers[k].y;
        }
        speeds[i] = std::sqrt(x * x + y * y);
    }
}

BATTEN_VECTORIZED void fill_speeds(const Vector* powers, std::size_t count, const double* places, double* speeds) {
    switch (count) {
        case 2:
            return fill_speeds_of(powers, std::integral_constant<std::size_t, 2>(), places, speeds);
        case 3:
            return fill_speeds_of(powers, std::integral_constant<std::size_t, 3>(), places, speeds);
        default:
            return fill_speeds_of(powers, count, places, speeds);
    }
}

// The same of the quotient of two polynomials: (N' - N/w w') / w.
template <class Count>
[[gnu::always_inline]] inline void fill_rational_speeds_of(const Vector* powers, const double* weights, Count count,
                                                           const double* places, double* speeds) {
    BATTEN_INDEPENDENT
    for (std::size_t i = 0; i < node_count; ++i) {
        double x = powers[count - 1].x;
        double y = powers[count - 1].y;
        double w = weights[count - 1];
        double dx = 0.0;
        double dy = 0.0;
        double dw = 0.0;
        for (std::size_t k = count - 1; k-- > 0;) {
            dx = dx * places[i] + x;
            dy = dy * places[i] + y;
            dw = dw * places[i] + w;
            x = x * places[i] + powers[k].x;
            y = y * places[i] + powers[k].y;
            w = w * places[i] + weights[k];
        }
        const double vx = dx - x / w * dw;
        const double vy = dy - y / w * dw;
        speeds[i] = std::sqrt(vx * vx + vy * vy) / w;
    }
}

BATTEN_VECTORIZED void fill_rational_speeds(const Vector* powers, const double* weights, std::size_t count,
                                            const double* places, double* speeds) {
    switch (count) {
        case 3:
            return fill_rational_speeds_of(powers, weights, std::integral_constant<std::size_t, 3>(), places, speeds);
        case 4:
            return fill_rational_speeds_of(powers, weights, std::integral_constant<std::size_t, 4>(), places, speeds);
        default:
            return fill_rational_speeds_of(powers, weights, count, places, speeds);
    }
}

bool has_squares(std::span<const Vector> vectors) {
    double largest = 0.0;
    for (const Vector& v : vectors) largest = std::max({largest, std::abs(v.x), std::abs(v.y)});
    return squared_well.contains(largest);
}

// Those of a polynomial in Bernstein form about its middle: a derivative of order k divided by k! is binomial(n, k)
// times the k-th difference, blended at the middle.
template <class Value, std::size_t Most, class Count>
void fill_powers(std::array<Value, Most> form, Count count, std::array<Value, Most>& powers) {
    double binomial = 1.0;
    for (std::size_t k = 0; k < count; ++k) {
        if (k > 0) {
            binomial = next_binomial(binomial, count - 1, k);
            for (std::size_t i = 0; i + k < count; ++i) form[i] = form[i + 1] - form[i];
        }
        std::array<Value, Most> blended;
        for (std::size_t i = 0; i + k < count; ++i) blended[i] = form[i];
        for (std::size_t left = count - 1 - k; left > 0; --left)
            for (std::size_t i = 0; i < left; ++i) blended[i] = 0.5 * (blended[i] + blended[i + 1]);
        powers[k] = binomial * blended[0];
    }
}

bool are_onward(std::span<const Vector> vectors) {
    Vector sum{};
    for (const Vector& v : vectors) sum += v;
    return std::ranges::all_of(vectors, [&](const Vector& v) { return dot(v, sum) > 0.0; });
}

}  // namespace

SpeedForm::SpeedForm(const PieceMotion& piece) {
    if (piece.is_polynomial())
        take_polynomial(piece.points());
    else
        take_rational(piece.points());
}

void SpeedForm::take_polynomial(std::span<const HomogeneousPoint> points) {
    const std::size_t p = points.size() - 1;
    if (p > most_powers) return;
    std::array<Vector, most_powers> legs{};
    for (std::size_t i = 0; i < p; ++i)
        legs[i] = static_cast<double>(p) / points[i].z * plane_part(points[i + 1] - points[i]);
    const auto hodograph = std::span(legs).first(p);
    if (!has_squares(hodograph)) return;
    count_ = p;
    goes_onward_ = are_onward(hodograph);
    with_known_degree(p, [&](auto known) { fill_powers(legs, known, powers_); });
}

// The velocity of a rational piece is a sum of its legs, none of them taken negatively. Source: Sederberg and Wang,
// Rational hodographs.
void SpeedForm::take_rational(std::span<const HomogeneousPoint> points) {
    const std::size_t p = points.size() - 1;
    if (p + 1 > most_powers) return;
    const auto [least, largest] = std::ranges::minmax(points, {}, &HomogeneousPoint::z);
    if (!(largest.z < most_weight_ratio * least.z)) return;
    // A power of two, so that nothing is rounded.
    const int scale = -std::ilogb(largest.z);
    const Vector origin = plane_part(points[p / 2]) / points[p / 2].z;
    std::array<Vector, most_powers> places{};
    std::array<double, most_powers> weights{};
    std::array<Vector, most_powers> legs{};
    for (std::size_t i = 0; i <= p; ++i) {
        weights[i] = std::ldexp(points[i].z, scale);
        const Vector numerator(std::ldexp(points[i].x, scale), std::ldexp(points[i].y, scale));
        places[i] = numerator - weights[i] * origin;
        if (i > 0) legs[i - 1] = places[i] / weights[i] - places[i - 1] / weights[i - 1];
    }
    if (!has_squares(std::span(legs).first(p))) return;
    count_ = p + 1;
    is_rational_ = true;
    goes_onward_ = are_onward(std::span(legs).first(p));
    with_known_degree(count_, [&](auto known) {
        fill_powers(places, known, powers_);
        fill_powers(weights, known, weight_powers_);
    });
}

Vector SpeedForm::velocity(double s) const {
    assert(is_plain());
    Vector sum = powers_[count_ - 1];
    if (!is_rational_) {
        for (std::size_t k = count_ - 1; k-- > 0;) sum = s * sum + powers_[k];
        return sum;
    }
    double weight = weight_powers_[count_ - 1];
    Vector slope{};
    double weight_slope = 0.0;
    for (std::size_t k = count_ - 1; k-- > 0;) {
        slope = s * slope + sum;
        weight_slope = s * weight_slope + weight;
        sum = s * sum + powers_[k];
        weight = s * weight + weight_powers_[k];
    }
    return (slope - weight_slope / weight * sum) / weight;
}

RulePair<double> SpeedForm::rules(Interval interval) const {
    const double half = 0.5 * interval.length();
    const double middle = interval.lower + half;
    const double center = speed(middle);
    NodeValues places;
    NodeValues speeds;
    for (std::size_t i = 0; i < node_count / 2; ++i) {
        const double step = half * gauss_kronrod::nodes[i];
        places[i] = middle - step;
        places[i + node_count / 2] = middle + step;
    }
    if (is_rational_)
        fill_rational_speeds(powers_.data(), weight_powers_.data(), count_, places.data(), speeds.data());
    else
        fill_speeds(powers_.data(), count_, places.data(), speeds.data());
    // Differences from the middle are summed up, so that a constant is integrated to the last digit.
    double kronrod = 0.0;
    double gauss = 0.0;
    for (std::size_t i = 0; i < node_count / 2; ++i) {
        const double difference = (speeds[i] - center) + (speeds[i + node_count / 2] - center);
        kronrod += gauss_kronrod::weights[i] * difference;
        if (i % 2 == 1) gauss += gauss_kronrod::gauss_weights[i / 2] * difference;
    }
    const double whole = interval.length() * center;
    const DoubleDouble sum = exact_sum(whole, half * kronrod);
    return {interval, sum.high, whole + half * gauss, sum.low};
}

}  // namespace batten::core
