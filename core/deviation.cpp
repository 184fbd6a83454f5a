#include "core/deviation.h"

#include <glm/geometric.hpp>

#include "core/evaluate.h"

namespace batten::core {

namespace {

constexpr int samples_in_span = 32;

double map(double u, Interval from, Interval to) {
    if (from == to) return u;
    return to.clamp(to.lower + (u - from.lower) / from.length() * to.length());
}

// The largest distance over the spans of `a`.
double deviation_over_spans_of(const Curve& a, const Curve& b) {
    const Interval from = a.domain();
    const Interval to = b.domain();
    const auto distance = [&](double u, Side side) {
        return glm::distance(point_at(a, u, side), point_at(b, map(u, from, to), side));
    };
    const auto knots = a.knots().values();
    double largest = 0.0;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double lower = knots[i];
        const double upper = knots[i + 1];
        if (lower == upper || lower < from.lower || upper > from.upper) continue;
        for (int k = 0; k < samples_in_span; ++k)
            largest = std::max(largest, distance(lower + (upper - lower) * k / samples_in_span, Side::right));
        largest = std::max(largest, distance(upper, Side::left));
    }
    return largest;
}

}  // namespace

double largest_deviation(const Curve& a, const Curve& b) {
    return std::max(deviation_over_spans_of(a, b), deviation_over_spans_of(b, a));
}

}  // namespace batten::core
