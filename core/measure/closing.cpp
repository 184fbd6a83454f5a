#include "core/measure/closing.h"

#include <cassert>
#include <cmath>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

constexpr double closing_rounding = 4.0 * std::numeric_limits<double>::epsilon();

// The knots repeat after the domain's length, up to closing_rounding and `tolerance` of it.
bool knots_repeat(const KnotVector& knots, std::size_t period, double tolerance) {
    const Interval domain = knots.domain();
    const double largest = std::max(std::abs(knots.values().front()), std::abs(knots.values().back()));
    const double allowed = tolerance * domain.length() + closing_rounding * largest;
    for (std::size_t i = 0; i + period < knots.size(); ++i)
        if (std::abs(knots[i + period] - knots[i] - domain.length()) > allowed) return false;
    return true;
}

bool points_repeat(const Curve& curve, std::size_t period, double tolerance) {
    const auto points = curve.control_points();
    const auto weights = curve.weights();
    const double allowed = absolute_tolerance(curve, tolerance);
    for (std::size_t i = 0; i + period < points.size(); ++i) {
        if (distance(points[i], points[i + period]) > allowed) return false;
        if (std::abs(weights[i] - weights[i + period]) > (tolerance + closing_rounding) * weights[i]) return false;
    }
    return true;
}

bool is_wrapped(const Curve& curve, double tolerance) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t period = curve.control_points().size() - p;
    // A periodic curve has at least two points.
    return period >= 2 && knots_repeat(curve.knots(), period, tolerance) && points_repeat(curve, period, tolerance);
}

int measured_continuity(const Curve& curve, double tolerance) {
    const auto [lower, upper] = curve.domain();
    const auto u = curve.knots().values();
    const std::size_t first = curve.knots().span_at(lower);
    const std::size_t last = curve.knots().span_at(upper);
    const double step = std::min(u[first + 1] - u[first], u[last + 1] - u[last]);
    const Jet start = derivatives_at(curve, lower, curve.degree(), Side::right);
    const Jet end = derivatives_at(curve, upper, curve.degree(), Side::left);
    double allowed = absolute_tolerance(curve, tolerance);
    if (!(distance(start.point, end.point) <= allowed)) return -1;
    int continuity = 0;
    for (std::size_t k = 1; k <= start.derivatives.size(); ++k) {
        allowed *= static_cast<double>(curve.degree()) / step;
        if (!(length(end[k] - start[k]) <= allowed)) break;
        continuity = static_cast<int>(k);
    }
    return continuity;
}

}  // namespace

double absolute_tolerance(const Curve& curve, double relative) {
    return absolute_tolerance(control_box(curve), relative);
}

double absolute_tolerance(const Box& box, double relative) {
    assert(relative >= 0.0 && !box.is_empty());
    const double largest =
        std::max({std::abs(box.lower.x), std::abs(box.lower.y), std::abs(box.upper.x), std::abs(box.upper.y)});
    return std::max(relative * std::max(box.size().x, box.size().y), closing_rounding * largest);
}

ClosingReport closing_of(const Curve& curve, double tolerance) {
    assert(tolerance > 0.0);
    const auto [lower, upper] = curve.domain();
    if (curve.is_periodic())
        return {.closing = Closing::periodic, .continuity = curve.degree() - curve.knots().multiplicity(lower)};
    const double gap = distance(point_at(curve, lower), point_at(curve, upper));
    const int continuity = measured_continuity(curve, tolerance);
    if (continuity < 0) return {.closing = Closing::open, .gap = gap};
    const Closing closing = is_wrapped(curve, tolerance) ? Closing::wrapped : Closing::ends_meet;
    return {.closing = closing, .gap = gap, .continuity = continuity};
}

}  // namespace batten::core
