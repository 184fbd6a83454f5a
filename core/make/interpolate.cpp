#include "core/make/interpolate.h"

#include <cmath>
#include <utility>

#include "core/curve/detail/trusted.h"
#include "core/make/detail/collocation.h"
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

// Distances of knots that have products of six without over- or underflow.
constexpr Interval moderate_distances{1e-45, 1e45};

bool are_moderately_apart(std::span<const double> knots) {
    if (!(knots.back() - knots.front() < moderate_distances.upper)) return false;
    std::size_t apart = 1;
    for (std::size_t i = 1; i < knots.size(); ++i)
        apart += knots[i] - knots[i - 1] > moderate_distances.lower ? 1U : 0U;
    return apart == knots.size();
}

// The knots inside of clamped ones and both ends.
std::span<const double> breaks_of(std::span<const double> knots, std::size_t p) {
    return knots.subspan(p, knots.size() - 2 * p);
}

Result<Curve> solved(const SplineSystem& system, const Progress& progress) {
    auto points = system.solve(progress);
    if (!points) return refuse({.code = CurveErrorCode::equations_singular});
    return Curve::make(system.knots(), *std::move(points), {});
}

// Open curves in the making.
struct OpenInterpolation {
    std::span<const Point> points;
    const std::vector<double>& parameters;
    const Ends& ends;
    EndNeeds needs;
    const Progress& progress;

    std::vector<double> knots(std::size_t p) const {
        const bool is_natural = std::holds_alternative<NaturalEnds>(ends);
        if (is_natural && p == 3) return knots_at_parameters(parameters, p);
        return needs.count() == 0 ? averaged_knots(parameters, p) : averaged_knots(sites_of(parameters, needs), p);
    }

    Result<Curve> by_system(KnotVector knots) const {
        const EndPoints fixed = end_points(points.front(), points.back(), ends, knots);
        SplineSystem system(std::move(knots), points.front(), fixed);
        for (std::size_t k = 1; k + 1 < points.size(); ++k) system.require_point(parameters[k], points[k]);
        return solved(system, progress).and_then([&](const Curve& curve) {
            std::vector<Point> exact(curve.control_points().begin(), curve.control_points().end());
            exact.front() = points.front();
            exact.back() = points.back();
            return Curve::make(curve.knots(), std::move(exact), {});
        });
    }

    // Of a cubic whose knots are apart.
    std::optional<Curve> by_collocation(const KnotVector& knots) const {
        const EndPoints fixed = end_points(points.front(), points.back(), ends, knots);
        auto found = needs.count() == 0
                         ? collocated({knots.values(), parameters, points, fixed})
                         : collocated({knots.values(), sites_of(parameters, needs), points_beside(fixed), fixed});
        if (!found) return std::nullopt;
        std::vector<double> weights(found->size(), 1.0);
        return Trusted::curve(knots, *std::move(found), std::move(weights), false);
    }

    // The points, and beside the ends one for each condition there.
    std::vector<Point> points_beside(const EndPoints& fixed) const {
        std::vector<Point> all(needs.at_start, points.front());
        all.insert(all.end(), points.begin(), points.end());
        all.insert(all.end(), needs.at_end, points.back());
        for (const KnownPoint& known : fixed.known) all[known.index] = known.point;
        return all;
    }
};

Result<Interpolation> interpolate_open(std::span<const Point> points, const InterpolationRequest& request,
                                       std::vector<double> parameters, const Progress& progress) {
    const auto p = static_cast<std::size_t>(request.degree);
    const OpenInterpolation open{points, parameters, request.ends, needs_of(request.ends), progress};
    if (points.size() + open.needs.count() < p + 1)
        return refuse({.code = CurveErrorCode::data_points_too_few,
                       .value = static_cast<double>(points.size()),
                       .lower = static_cast<double>(p + 1 - open.needs.count())});
    if (const auto check = check_tangents(request.ends); !check) return refuse(check.error());
    std::vector<double> values = open.knots(p);
    const bool are_apart = are_moderately_apart(breaks_of(values, p));
    auto knots = are_apart ? Trusted::knots(request.degree, false, KnotKind::custom, std::move(values))
                           : KnotVector::make(request.degree, std::move(values));
    if (!knots) return refuse(knots.error());
    std::optional<Curve> curve;
    if (p == 3 && are_apart) curve = open.by_collocation(*knots);
    if (curve) return Interpolation{*std::move(curve), std::move(parameters)};
    return open.by_system(*std::move(knots)).map([&](Curve solution) {
        return Interpolation{std::move(solution), std::move(parameters)};
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
                                         std::vector<double> parameters, const Progress& progress) {
    std::vector<double> period = request.degree % 2 == 1 ? parameters : midway_period(parameters);
    auto knots = KnotVector::make_periodic(request.degree, std::move(period), KnotKind::periodic);
    if (!knots) return refuse(knots.error());
    SplineSystem system(*std::move(knots), points.front());
    parameters.pop_back();
    for (std::size_t k = 0; k < points.size(); ++k) system.require_point(parameters[k], points[k]);
    return solved(system, progress).map([&](Curve curve) {
        return Interpolation{std::move(curve), std::move(parameters)};
    });
}

}  // namespace

Result<Interpolation> interpolate(std::span<const Point> points, const InterpolationRequest& request,
                                  const Progress& progress) {
    if (const auto check = check_degree(request.degree); !check) return refuse(check.error());
    if (const auto check = check_degree_of_ends(request.ends, request.degree); !check) return refuse(check.error());
    auto parameters = parameters_for(points, request);
    if (!parameters) return refuse(parameters.error());
    return is_closed(request.ends) ? interpolate_closed(points, request, *std::move(parameters), progress)
                                   : interpolate_open(points, request, *std::move(parameters), progress);
}

}  // namespace batten::core
