#include "core/make/interpolate.h"

#include <cmath>
#include <utility>

#include "core/evaluate/detail/spline_system.h"

namespace batten::core {

namespace {

// How many derivatives are prescribed at both ends, and the least degree that has them.
struct EndNeeds {
    std::size_t at_start = 0;
    std::size_t at_end = 0;
    int least_degree = min_degree;
    bool is_finite = true;
};

EndNeeds needs_of(const Ends& ends) {
    if (std::holds_alternative<NaturalEnds>(ends)) return {1, 1, 3};
    const auto* tangents = std::get_if<EndTangents>(&ends);
    if (tangents == nullptr || (!tangents->start && !tangents->end)) return {};
    return {tangents->start ? 1U : 0U, tangents->end ? 1U : 0U, 2,
            is_finite(tangents->start.value_or(Vector{})) && is_finite(tangents->end.value_or(Vector{}))};
}

Result<std::vector<double>> parameters_for(std::span<const Point> points, const InterpolationRequest& request) {
    const bool is_closed = std::holds_alternative<ClosedEnds>(request.ends);
    if (request.parameters.empty()) return parametrize(points, request.parametrization, is_closed);
    if (const auto check = check_parameters(points, request.parameters, is_closed); !check)
        return refuse(check.error());
    return request.parameters;
}

// The parameters, with those of the ends as often as there are conditions there.
std::vector<double> sites_of(std::span<const double> parameters, const EndNeeds& needs) {
    std::vector<double> sites(needs.at_start, parameters.front());
    sites.insert(sites.end(), parameters.begin(), parameters.end());
    sites.insert(sites.end(), needs.at_end, parameters.back());
    return sites;
}

std::vector<double> knots_at_parameters(std::span<const double> parameters, std::size_t p) {
    std::vector<double> knots(p, parameters.front());
    knots.insert(knots.end(), parameters.begin(), parameters.end());
    knots.insert(knots.end(), p, parameters.back());
    return knots;
}

Result<Curve> solved(const SplineSystem& system) {
    auto points = system.solve();
    if (!points) return refuse({.code = CurveErrorCode::equations_singular});
    return Curve::make(system.knots(), *std::move(points), {});
}

// The ends, and beside an end with a tangent the next control point: C'(u_p) = p (P_1 - P_0) / (u_{p+1} - u_1).
std::vector<KnownPoint> known_points(std::span<const Point> points, const Ends& ends, const KnotVector& knots) {
    const auto p = static_cast<std::size_t>(knots.degree());
    const std::size_t last = knots.control_point_count() - 1;
    std::vector<KnownPoint> known{{0, points.front()}, {last, points.back()}};
    const auto* tangents = std::get_if<EndTangents>(&ends);
    if (tangents == nullptr) return known;
    const auto degree = static_cast<double>(p);
    if (tangents->start) known.push_back({1, points.front() + (knots[p + 1] - knots[1]) / degree * *tangents->start});
    if (tangents->end)
        known.push_back({last - 1, points.back() - (knots[last + p] - knots[last]) / degree * *tangents->end});
    return known;
}

// Weighed by the squared length of the span, so that the coefficients are of the size of all others.
void require_natural_ends(SplineSystem& system) {
    const auto [lower, upper] = system.knots().domain();
    const KnotVector& knots = system.knots();
    const double first = knots[knots.span_at(lower) + 1] - lower;
    const double last = upper - knots[knots.span_at(upper)];
    system.require_derivative(lower, 2, Vector{}, first * first);
    system.require_derivative(upper, 2, Vector{}, last * last);
}

Result<Interpolation> interpolate_open(std::span<const Point> points, const InterpolationRequest& request,
                                       std::vector<double> parameters) {
    const auto p = static_cast<std::size_t>(request.degree);
    const EndNeeds needs = needs_of(request.ends);
    const std::size_t count = points.size() + needs.at_start + needs.at_end;
    if (count < p + 1)
        return refuse({.code = CurveErrorCode::data_points_too_few,
                       .value = static_cast<double>(points.size()),
                       .lower = static_cast<double>(p + 1 - needs.at_start - needs.at_end)});
    if (!needs.is_finite) return refuse({.code = CurveErrorCode::vector_not_finite});
    const bool is_natural = std::holds_alternative<NaturalEnds>(request.ends);
    auto knots =
        KnotVector::make(request.degree, is_natural && p == 3 ? knots_at_parameters(parameters, p)
                                                              : averaged_knots(sites_of(parameters, needs), p));
    if (!knots) return refuse(knots.error());

    const std::vector<KnownPoint> known = known_points(points, request.ends, *knots);
    SplineSystem system(*std::move(knots), points.front(), known);
    if (is_natural) require_natural_ends(system);
    for (std::size_t k = 1; k + 1 < points.size(); ++k) system.require_point(parameters[k], points[k]);
    return solved(system).map([&](Curve curve) {
        CurveDefinition definition = curve.definition();
        definition.points.front() = points.front();
        definition.points.back() = points.back();
        return Interpolation{Curve::make(std::move(definition)).value(), std::move(parameters)};
    });
}

// One period with knots midway between the parameters, which are shifted so that it begins where the old one did.
std::vector<double> midway_period(std::vector<double>& parameters) {
    const std::size_t n = parameters.size() - 1;
    const double lower = parameters.front();
    const double upper = parameters.back();
    const double shift = 0.5 * (parameters[n] - parameters[n - 1]);
    std::vector<double> period{lower};
    for (std::size_t k = 1; k < n; ++k)
        period.push_back(std::min(parameters[k - 1] + 0.5 * (parameters[k] - parameters[k - 1]) + shift, upper));
    period.push_back(upper);
    for (double& parameter : parameters) parameter += shift;
    return period;
}

Result<Interpolation> interpolate_closed(std::span<const Point> points, const InterpolationRequest& request,
                                         std::vector<double> parameters) {
    std::vector<double> period = request.degree % 2 == 1 ? parameters : midway_period(parameters);
    auto knots = KnotVector::make_periodic(request.degree, std::move(period), KnotKind::periodic);
    if (!knots) return refuse(knots.error());
    SplineSystem system(*std::move(knots), points.front());
    parameters.pop_back();
    for (std::size_t k = 0; k < points.size(); ++k) system.require_point(parameters[k], points[k]);
    return solved(system).map([&](Curve curve) { return Interpolation{std::move(curve), std::move(parameters)}; });
}

}  // namespace

Result<Interpolation> interpolate(std::span<const Point> points, const InterpolationRequest& request) {
    if (const auto check = check_degree(request.degree); !check) return refuse(check.error());
    if (const int least = needs_of(request.ends).least_degree; request.degree < least)
        return refuse({.code = CurveErrorCode::degree_too_low,
                       .value = static_cast<double>(request.degree),
                       .lower = static_cast<double>(least)});
    auto parameters = parameters_for(points, request);
    if (!parameters) return refuse(parameters.error());
    return std::holds_alternative<ClosedEnds>(request.ends)
               ? interpolate_closed(points, request, *std::move(parameters))
               : interpolate_open(points, request, *std::move(parameters));
}

}  // namespace batten::core
