/// What a curve is at its ends, measured without the formulas under test: the change of curvature by differences.
#pragma once

#include <cmath>

#include "core/curve/curve_end.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/meeting.h"

namespace batten::core {

/// d curvature / ds at `u` from one side, by one-sided differences of third order of the curvature, over that way for
/// which the half of it says most nearly the same.
inline double change_by_differences(const Curve& curve, double u, Side side) {
    const std::size_t span = curve.knots().span_at(u, side);
    const double length_of_span = curve.knots()[span + 1] - curve.knots()[span];
    const auto slope = [&](double h) {
        const auto bend = [&](double k) { return curvature_at(curve, u + k * h, side).value(); };
        return (-11.0 * bend(0) + 18.0 * bend(1) - 9.0 * bend(2) + 2.0 * bend(3)) / (6.0 * h);
    };
    double best = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 4; k < 30; ++k) {
        const double h = (side == Side::right ? 1.0 : -1.0) * std::ldexp(length_of_span, -k);
        const double found = slope(h);
        const double difference = std::abs(found - slope(0.5 * h));
        if (difference < least) {
            least = difference;
            best = found;
        }
    }
    return best / length(derivatives_at(curve, u, 1, side)[1]);
}

/// How a curve goes on beyond this end.
inline Passing measured_beyond(const Curve& curve, CurveEnd end) {
    const double u = parameter_of(curve.domain(), end);
    const Side side = end == CurveEnd::start ? Side::right : Side::left;
    const double sense = end == CurveEnd::start ? -1.0 : 1.0;
    const Jet jet = derivatives_at(curve, u, 1, side);
    return {.point = jet.point,
            .direction = sense * jet[1] / length(jet[1]),
            .curvature = sense * curvature_at(curve, u, side).value(),
            .change = change_by_differences(curve, u, side)};
}

/// The largest difference of two passings in what `continuity` speaks of, curvature and its change in units in which
/// `size` is 1 and relative to themselves.
inline double difference_of(const Passing& a, const Passing& b, GeometricContinuity continuity, double size) {
    const int order = order_of(continuity);
    const auto relative = [](double first, double second, double unit) {
        return std::abs(first - second) / std::max({std::abs(first), std::abs(second), unit});
    };
    double worst = length(a.point - b.point) / size;
    if (order >= 1) worst = std::max(worst, length(*a.direction - *b.direction));
    if (order >= 2) worst = std::max(worst, relative(*a.curvature, *b.curvature, 1.0 / size));
    // Differences are right to six digits or so.
    if (order >= 3) {
        const double unit = std::max(1.0 / size / size, *a.curvature * *a.curvature);
        worst = std::max(worst, 1e-4 * relative(*a.change, *b.change, unit));
    }
    return worst;
}

}  // namespace batten::core
