#include "core/measure/deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

// Denser toward the ends of a span, where polynomials of high degree have their narrowest peaks.
std::vector<double> sample_shares(int degree) {
    const int count = std::max(32, 4 * degree);
    std::vector<double> shares;
    for (int k = 0; k <= count; ++k) {
        const double sine = std::sin(0.5 * std::numbers::pi * k / count);
        shares.push_back(2 * k == count ? 0.5 : sine * sine);
    }
    shares.back() = 1.0;
    return shares;
}

// The larger of both; infinite where the distance is too large for a double.
double larger(double largest, double distance) {
    return std::isnan(distance) ? std::numeric_limits<double>::infinity() : std::max(largest, distance);
}

double map(double u, Interval from, Interval to) {
    if (from == to) return u;
    return to.clamp(to.lower + (u - from.lower) / from.length() * to.length());
}

// The largest distance over the spans of `a`.
double deviation_over_spans_of(const Curve& a, const Curve& b) {
    const Interval from = a.domain();
    const Interval to = b.domain();
    const auto distance = [&](double u, Side side) {
        return core::distance(point_at(a, u, side), point_at(b, map(u, from, to), side));
    };
    const std::vector<double> shares = sample_shares(std::max(a.degree(), b.degree()));
    const auto knots = a.knots().values();
    double largest = 0.0;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double lower = knots[i];
        const double upper = knots[i + 1];
        if (lower == upper || lower < from.lower || upper > from.upper) continue;
        for (const double share : shares)
            largest = larger(largest, share < 1.0 ? distance(lower + (upper - lower) * share, Side::right)
                                                  : distance(upper, Side::left));
    }
    return largest;
}

}  // namespace

double largest_deviation(const Curve& a, const Curve& b) {
    return std::max(deviation_over_spans_of(a, b), deviation_over_spans_of(b, a));
}

}  // namespace batten::core
