#include "core/measure/detail/speed_form.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/detail/binomial.h"
#include "core/base/detail/vectorized.h"

namespace batten::core {

namespace {

// Numbers of sizes that have squares without over- or underflow.
constexpr Interval squared_well{1e-140, 1e140};

constexpr std::size_t node_count = 2 * gauss_kronrod::nodes.size();

using NodeValues = std::array<double, node_count>;

// The speeds at all nodes, pair by pair.
BATTEN_VECTORIZED void fill_speeds(const Vector* powers, std::size_t count, const NodeValues& places,
                                   NodeValues& speeds) {
    NodeValues x;
    NodeValues y;
    for (std::size_t i = 0; i < node_count; ++i) {
        x[i] = powers[count - 1].x;
        y[i] = powers[count - 1].y;
    }
    for (std::size_t k = count - 1; k-- > 0;)
        for (std::size_t i = 0; i < node_count; ++i) {
            x[i] = x[i] * places[i] + powers[k].x;
            y[i] = y[i] * places[i] + powers[k].y;
        }
    for (std::size_t i = 0; i < node_count; ++i) speeds[i] = std::sqrt(x[i] * x[i] + y[i] * y[i]);
}

bool has_squares(std::span<const Vector> vectors) {
    double largest = 0.0;
    for (const Vector& v : vectors) largest = std::max({largest, std::abs(v.x), std::abs(v.y)});
    return squared_well.contains(largest);
}

}  // namespace

// A derivative of order k divided by k! is binomial(n, k) times the k-th difference, blended at the middle.
SpeedForm::SpeedForm(const PieceMotion& piece) {
    const std::span<const HomogeneousPoint> points = piece.points();
    const std::size_t p = points.size() - 1;
    if (p > highest_degree || !piece.is_polynomial()) return;
    std::array<Vector, highest_degree> legs{};
    for (std::size_t i = 0; i < p; ++i)
        legs[i] = static_cast<double>(p) / points[i].z * plane_part(points[i + 1] - points[i]);
    if (!has_squares(std::span(legs).first(p))) return;
    count_ = p;
    double binomial = 1.0;
    for (std::size_t k = 0; k < p; ++k) {
        if (k > 0) {
            binomial = next_binomial(binomial, p - 1, k);
            for (std::size_t i = 0; i + k < p; ++i) legs[i] = legs[i + 1] - legs[i];
        }
        std::array<Vector, highest_degree> blended = legs;
        for (std::size_t left = p - 1 - k; left > 0; --left)
            for (std::size_t i = 0; i < left; ++i) blended[i] = 0.5 * (blended[i] + blended[i + 1]);
        powers_[k] = binomial * blended[0];
    }
}

Vector SpeedForm::velocity(double s) const {
    assert(is_plain());
    Vector sum = powers_[count_ - 1];
    for (std::size_t k = count_ - 1; k-- > 0;) sum = s * sum + powers_[k];
    return sum;
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
    fill_speeds(powers_.data(), count_, places, speeds);
    // Differences from the middle are summed up, so that a constant is integrated to the last digit.
    double kronrod = 0.0;
    double gauss = 0.0;
    for (std::size_t i = 0; i < node_count / 2; ++i) {
        const double difference = (speeds[i] - center) + (speeds[i + node_count / 2] - center);
        kronrod += gauss_kronrod::weights[i] * difference;
        if (i % 2 == 1) gauss += gauss_kronrod::gauss_weights[i / 2] * difference;
    }
    const double whole = interval.length() * center;
    return {interval, whole + half * kronrod, whole + half * gauss};
}

}  // namespace batten::core
