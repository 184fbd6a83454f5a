#include <algorithm>
#include <cmath>

#include "core/blossom.h"
#include "core/degree.h"
#include "core/knot_analysis.h"

namespace batten::core {

namespace {

// Every run of equal knots with one knot more. The seam of a period is one run, and gains at its lower end.
std::vector<double> with_longer_runs(std::span<const double> knots, bool is_periodic) {
    std::vector<double> longer;
    longer.reserve(2 * knots.size());
    for (std::size_t i = 0; i < knots.size(); ++i) {
        longer.push_back(knots[i]);
        const bool ends_run = i + 1 == knots.size() || knots[i + 1] != knots[i];
        const bool is_seam_again = is_periodic && knots[i] == knots.back();
        if (ends_run && !is_seam_again) longer.push_back(knots[i]);
    }
    return longer;
}

std::ptrdiff_t distinct_values(std::span<const double> sorted) {
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i)
        if (i == 0 || sorted[i] != sorted[i - 1]) ++count;
    return count;
}

Result<KnotVector> elevated_knots(const Curve& curve) {
    const KnotVector& knots = curve.knots();
    std::vector<double> longer = with_longer_runs(knots.stored(), knots.is_periodic());
    if (knots.is_periodic()) return KnotVector::make_periodic(knots.degree() + 1, std::move(longer), knots.kind());
    // Outside the domain only degree knots are needed on either side.
    const auto all = knots.values();
    const auto ends = static_cast<std::size_t>(knots.degree()) + 1;
    longer.erase(longer.end() - (distinct_values(all.last(ends)) - 1), longer.end());
    longer.erase(longer.begin(), longer.begin() + (distinct_values(all.first(ends)) - 1));
    return KnotVector::make(knots.degree() + 1, std::move(longer), knots.kind(), curve.definition().tears);
}

// The blossom of degree p+1 is the mean of the old one over all ways to leave one argument out.
HomogeneousPoint elevated_blossom(const Curve& curve, std::size_t span, std::span<const double> arguments) {
    HomogeneousPoint mean(0.0);
    for (std::size_t i = 0; i < arguments.size();) {
        std::size_t end = i;
        while (end < arguments.size() && arguments[end] == arguments[i]) ++end;
        std::vector<double> rest(arguments.begin(), arguments.end());
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
        // Of equal arguments it does not matter which one is left out.
        const double share = static_cast<double>(end - i) / static_cast<double>(arguments.size());
        mean += share * blossom(curve, span, rest);
        i = end;
    }
    return mean;
}

// The mean of the knots j+1..j+q, where control point j acts.
double greville_abscissa(std::span<const double> arguments) {
    double mean = 0.0;
    for (const double argument : arguments) mean += (argument - arguments[0]) / static_cast<double>(arguments.size());
    return arguments[0] + mean;
}

// Control point j of an open curve over the knots of the higher degree: the blossom at its knots, of a piece on which
// it acts. A point beyond a run of knots at an end acts nowhere; there are as many of these as before, and they stay.
HomogeneousPoint elevated_open_point(const Curve& curve, const KnotVector& knots, std::size_t j) {
    const auto q = static_cast<std::size_t>(knots.degree());
    const Interval domain = knots.domain();
    if (knots[j + q + 1] <= domain.lower) return curve.homogeneous_point(j);
    if (knots[j] >= domain.upper)
        return curve.homogeneous_point(curve.control_points().size() - (knots.control_point_count() - j));
    const auto arguments = knots.values().subspan(j + 1, q);
    const double mean = greville_abscissa(arguments);
    const Side side = knots[j + q + 1] == mean ? Side::left : Side::right;
    return elevated_blossom(curve, curve.knots().span_at(mean, side), arguments);
}

// The same for a periodic curve, by whole periods inside the domain.
HomogeneousPoint elevated_periodic_point(const Curve& curve, const KnotVector& knots, std::size_t j) {
    const auto values = knots.values().subspan(j + 1, static_cast<std::size_t>(knots.degree()));
    const double mean = greville_abscissa(values);
    const double period = curve.domain().length();
    const double shift = period * std::round((knots.into_domain(mean) - mean) / period);
    std::vector<double> arguments(values.begin(), values.end());
    for (double& argument : arguments) argument += shift;
    return elevated_blossom(curve, curve.knots().span_at(mean + shift), arguments);
}

Result<Curve> elevate_once(const Curve& curve) {
    auto knots = elevated_knots(curve);
    if (!knots) return tl::unexpected(knots.error());
    std::vector<Point> points;
    std::vector<double> weights;
    for (std::size_t j = 0; j < knots->control_point_count(); ++j) {
        const HomogeneousPoint point =
            curve.is_periodic() ? elevated_periodic_point(curve, *knots, j) : elevated_open_point(curve, *knots, j);
        points.push_back(project(point));
        // Rounding must not make a polynomial curve rational.
        weights.push_back(curve.is_rational() ? point.z : curve.weights().front());
    }
    if (is_clamped(*knots)) {
        points.front() = curve.control_points().front();
        points.back() = curve.control_points().back();
    }
    return Curve::make(std::move(*knots), std::move(points), std::move(weights));
}

}  // namespace

Result<Curve> elevate_degree(const Curve& curve, int by) {
    if (by < 1 || curve.degree() + by > max_degree)
        return tl::unexpected(CurveError{.code = CurveErrorCode::degree_out_of_range,
                                         .value = static_cast<double>(curve.degree()) + static_cast<double>(by)});
    Result<Curve> elevated = curve;
    for (int i = 0; i < by; ++i) elevated = elevated.and_then(elevate_once);
    return elevated;
}

}  // namespace batten::core
