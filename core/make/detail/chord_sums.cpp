#include "core/make/detail/chord_sums.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/detail/vectorized.h"

namespace batten::core {

namespace {

constexpr std::size_t chords_at_once = 128;

// Squares of distances that have exact products without over- or underflow.
constexpr Interval exact_squares{1e-200, 1e200};

// A number and what it lacks.
struct Parts {
    double high;
    double low;
};

[[gnu::always_inline]] inline Parts exact_difference(double a, double b) {
    const double high = a - b;
    const double part_of_b = high - a;
    return {high, (a - (high - part_of_b)) - (b + part_of_b)};
}

// What a b lacks of the product: each factor is the sum of two halves, whose products are exact. Source: Dekker 1971.
[[gnu::always_inline]] inline double rest_of_product(double a, double b, double product) {
    constexpr double half_of_bits = 134217729.0;
    const double scaled_a = half_of_bits * a;
    const double scaled_b = half_of_bits * b;
    const double front_of_a = scaled_a - (scaled_a - a);
    const double front_of_b = scaled_b - (scaled_b - b);
    const double rest_of_a = a - front_of_a;
    const double rest_of_b = b - front_of_b;
    return ((front_of_a * front_of_b - product) + front_of_a * rest_of_b + rest_of_a * front_of_b) +
           rest_of_a * rest_of_b;
}

[[gnu::always_inline]] inline Parts root_of(Parts square) {
    const double root = std::sqrt(square.high);
    const double product = root * root;
    const double rest = ((square.high - product) - rest_of_product(root, root, product)) + square.low;
    return {root, 0.5 * rest / root};
}

[[gnu::always_inline]] inline Parts square_of_chord(Point from, Point to) {
    const Parts across = exact_difference(to.x, from.x);
    const Parts up = exact_difference(to.y, from.y);
    const double of_across = across.high * across.high;
    const double of_up = up.high * up.high;
    const double sum = of_across + of_up;
    const double larger = of_across < of_up ? of_up : of_across;
    const double smaller = of_across < of_up ? of_across : of_up;
    const double rests =
        rest_of_product(across.high, across.high, of_across) + rest_of_product(up.high, up.high, of_up);
    const double low = (smaller - (sum - larger)) + rests;
    return {sum, low + 2.0 * (across.high * across.low + up.high * up.low)};
}

// The lengths from each of the points to the next, or the roots of them; whether all can be trusted.
BATTEN_VECTORIZED bool fill_chords(const Point* points, std::size_t count, bool is_centripetal, double* high,
                                   double* low) {
    std::size_t trusted = 0;
    BATTEN_INDEPENDENT
    for (std::size_t k = 0; k < count; ++k) {
        const Parts square = square_of_chord(points[k], points[k + 1]);
        trusted += exact_squares.lower < square.high && square.high < exact_squares.upper ? 1U : 0U;
        const Parts length = root_of(square);
        high[k] = length.high;
        low[k] = length.low;
    }
    if (is_centripetal) {
        BATTEN_INDEPENDENT
        for (std::size_t k = 0; k < count; ++k) {
            const Parts root = root_of({high[k], low[k]});
            high[k] = root.high;
            low[k] = root.low;
        }
    }
    return trusted == count;
}

// Sums divided by the last of them.
BATTEN_VECTORIZED void fill_quotients(const double* high, const double* low, std::size_t count, double total,
                                      double rest_of_total, double* quotients) {
    const double share = 1.0 / total;
    BATTEN_INDEPENDENT
    for (std::size_t k = 0; k < count; ++k) {
        const double quotient = high[k] / total;
        const double product = quotient * total;
        const double rest =
            ((high[k] - product) - rest_of_product(quotient, total, product)) + (low[k] - quotient * rest_of_total);
        quotients[k] = quotient + rest * share;
    }
}

// Sums of chords from the first point on.
class ChordSums {
  public:
    explicit ChordSums(std::size_t chords) : high_(chords + 1, 0.0), low_(chords + 1, 0.0) {}

    // Of chords one after the other; whether all can be trusted.
    bool add(const Point* points, std::size_t count, bool is_centripetal) {
        std::array<double, chords_at_once> high;
        std::array<double, chords_at_once> low;
        if (!fill_chords(points, count, is_centripetal, high.data(), low.data())) return false;
        for (std::size_t k = 0; k < count; ++k, ++at_) {
            const double sum = high_[at_] + high[k];
            const double part = sum - high_[at_];
            low_[at_ + 1] = low_[at_] + (low[k] + ((high_[at_] - (sum - part)) + (high[k] - part)));
            high_[at_ + 1] = sum;
        }
        return true;
    }

    std::vector<double> shares() const {
        std::vector<double> shares(high_.size());
        fill_quotients(high_.data(), low_.data(), high_.size(), high_.back(), low_.back(), shares.data());
        return shares;
    }

  private:
    std::vector<double> high_;
    std::vector<double> low_;
    std::size_t at_ = 0;
};

}  // namespace

std::optional<std::vector<double>> shares_of_way(std::span<const Point> points, Parametrization parametrization,
                                                 bool is_closed) {
    if (parametrization == Parametrization::uniform) return std::nullopt;
    const bool is_centripetal = parametrization == Parametrization::centripetal;
    const std::size_t between = points.size() - 1;
    ChordSums sums(is_closed ? points.size() : between);
    for (std::size_t from = 0; from < between; from += chords_at_once)
        if (!sums.add(&points[from], std::min(chords_at_once, between - from), is_centripetal)) return std::nullopt;
    const std::array<Point, 2> back{points.back(), points.front()};
    if (is_closed && !sums.add(back.data(), 1, is_centripetal)) return std::nullopt;
    return sums.shares();
}

}  // namespace batten::core
