#include "core/make/interpolate.h"

#include <cmath>
#include <utility>

#include "core/make/detail/end_conditions.h"

namespace batten::core {

namespace {

Result<std::vector<double>> parameters_for(std::span<const Point> points, const InterpolationRequest& request) {
    const bool closed = is_closed(request.ends);
    if (request.parameters.empty()) return parametrize(points, request.parametrization, closed);
    if (const auto check = check_parameters(points, request.parameters, closed); !check) return refuse(check.error());
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

Result<Interpolation> interpolate_open(std::span<const Point> points, const InterpolationRequest& request,
                                       std::vector<double> parameters) {
    const auto p = static_cast<std::size_t>(request.degree);
    const EndNeeds needs = needs_of(request.ends);
    const std::size_t count = points.size() + needs.count();
    if (count < p + 1)
        return refuse({.code = CurveErrorCode::data_points_too_few,
                       .value = static_cast<double>(points.size()),
                       .lower = static_cast<double>(p + 1 - needs.count())});
    if (const auto check = check_tangents(request.ends); !check) return refuse(check.error());
    const bool is_natural = std::holds_alternative<NaturalEnds>(request.ends);
    auto knots =
        KnotVector::make(request.degree, is_natural && p == 3 ? knots_at_parameters(parameters, p)
                                                              : averaged_knots(sites_of(parameters, needs), p));
    if (!knots) return refuse(knots.error());

    const EndPoints ends = end_points(points.front(), points.back(), request.ends, *knots);
    SplineSystem system(*std::move(knots), points.front(), ends);
    for (std::size_t k = 1; k + 1 < points.size(); ++k) system.require_point(parameters[k], points[k]);
    return solved(system).map([&](const Curve& curve) {
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
    if (const auto check = check_degree_of_ends(request.ends, request.degree); !check) return refuse(check.error());
    auto parameters = parameters_for(points, request);
    if (!parameters) return refuse(parameters.error());
    return is_closed(request.ends) ? interpolate_closed(points, request, *std::move(parameters))
                                   : interpolate_open(points, request, *std::move(parameters));
}

}  // namespace batten::core
