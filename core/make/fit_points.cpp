#include "core/make/fit_points.h"

#include <algorithm>
#include <cmath>

#include "core/make/detail/fit_spans.h"

namespace batten::core {

namespace {

double step_of(Point from, Point to, Parametrization parametrization) {
    if (parametrization == Parametrization::uniform) return 1.0;
    const double chord = std::hypot(to.x - from.x, to.y - from.y);
    return parametrization == Parametrization::chordal ? chord : std::sqrt(chord);
}

std::vector<Point> places_of(const FitPoints& fit) {
    std::vector<Point> places;
    places.reserve(fit.points.size());
    for (const FitPoint& point : fit.points) places.push_back(point.place);
    return places;
}

tl::unexpected<CurveError> refuse_equal(std::size_t later, std::size_t earlier) {
    return refuse({.code = CurveErrorCode::points_coincide, .index = later, .value = static_cast<double>(earlier)});
}

// The sums of the steps; where two of them are one number, their points are too near beside the whole way.
Result<std::vector<double>> summed_steps(std::span<const Point> places, const FitForm& form) {
    const std::size_t n = places.size();
    std::vector<double> parameters{0.0};
    parameters.reserve(n + 1);
    for (std::size_t k = 1; k < n + (form.closed ? 1 : 0); ++k) {
        const double next = parameters.back() + step_of(places[k - 1], places[k % n], form.parametrization);
        if (!(next > parameters.back())) return refuse_equal(k % n, k - 1);
        if (!std::isfinite(next)) return refuse({.code = CurveErrorCode::not_computable});
        parameters.push_back(next);
    }
    return parameters;
}

Result<void> check_places(std::span<const Point> places, bool closed) {
    // Parametrization by numbers looks at nothing but whether there are enough points, which are finite.
    return parametrize(places, Parametrization::uniform, closed).map([](const auto&) {});
}

Result<void> check_index(const FitPoints& fit, std::size_t i) {
    if (i < fit.points.size()) return {};
    return refuse({.code = CurveErrorCode::fit_point_index_out_of_range,
                   .index = i,
                   .upper = static_cast<double>(fit.points.size()) - 1.0});
}

FitForm form_of(const FitPoints& fit) {
    return {fit.kind, fit.parametrization, fit.closed};
}

Result<FitPoints> reparametrized(FitPoints fit) {
    const std::vector<Point> places = places_of(fit);
    return check_places(places, fit.closed)
        .and_then([&] { return summed_steps(places, form_of(fit)); })
        .map([&](std::vector<double> parameters) {
            fit.parameters = std::move(parameters);
            return std::move(fit);
        });
}

// The number of the point after or before `i`, which a closed curve always has.
std::size_t after(const FitPoints& fit, std::size_t i) {
    return i + 1 == fit.points.size() ? 0 : i + 1;
}
std::size_t before(const FitPoints& fit, std::size_t i) {
    return i == 0 ? fit.points.size() - 1 : i - 1;
}

double step_after(const FitPoints& fit, std::size_t i) {
    return step_of(fit.points[i].place, fit.points[after(fit, i)].place, fit.parametrization);
}

// The parameter that parts [lower, upper] as the ways from point `i` to its neighbors are long.
Result<double> parted(const FitPoints& fit, std::size_t i, double lower, double upper) {
    const double way_in = step_after(fit, before(fit, i));
    const double way_out = step_after(fit, i);
    if (!(way_in > 0.0)) return refuse_equal(i, before(fit, i));
    if (!(way_out > 0.0)) return refuse_equal(after(fit, i), i);
    const double u = lower + (upper - lower) * (way_in / (way_in + way_out));
    if (!(lower < u && u < upper)) return refuse_equal(i, way_in < way_out ? before(fit, i) : after(fit, i));
    return u;
}

// The length of the span after point `i`, for its way, as that of another span for its own.
Result<double> like_span(const FitPoints& fit, std::size_t i, double length, double way) {
    const double span = length * (step_after(fit, i) / way);
    if (!(span > 0.0) || !std::isfinite(span)) return refuse_equal(after(fit, i), i);
    return span;
}

// After `moved` of the local kind has got another place than in `fit`.
Result<FitPoints> with_near_parameter(FitPoints moved, std::size_t i, const FitPoints& fit) {
    std::vector<double>& u = moved.parameters;
    const std::size_t last = moved.points.size() - 1;
    Result<double> found = u[i];
    if (!moved.closed && i == 0)
        found = like_span(moved, 0, u[1] - u[0], step_after(fit, 0)).map([&](double span) { return u[1] - span; });
    else if (!moved.closed && i == last)
        found = like_span(moved, last - 1, u[last] - u[last - 1], step_after(fit, last - 1)).map([&](double span) {
            return u[last - 1] + span;
        });
    else
        found = parted(moved, i, i > 0 ? u[i - 1] : u[last] - (u.back() - u[0]), u[i + 1]);
    if (!found) return refuse(found.error());
    // The period stays as long.
    if (moved.closed && i == 0) u.back() += *found - u[0];
    u[i] = *found;
    return moved;
}

// After point `i` was put into `fit` of the local kind without a parameter.
Result<FitPoints> with_new_parameter(FitPoints fit, std::size_t i) {
    std::vector<double>& u = fit.parameters;
    const std::size_t last = fit.points.size() - 1;
    Result<double> found = 0.0;
    if (!fit.closed && i == 0)
        found = like_span(fit, 0, u[1] - u[0], step_after(fit, 1)).map([&](double span) { return u[0] - span; });
    else if (!fit.closed && i == last)
        found = like_span(fit, last - 1, u[last - 1] - u[last - 2], step_after(fit, last - 2)).map([&](double span) {
            return u[last - 1] + span;
        });
    else
        found = parted(fit, i, u[i - 1], u[i]);
    if (!found) return refuse(found.error());
    u.insert(u.begin() + static_cast<std::ptrdiff_t>(i), *found);
    return fit;
}

}  // namespace

Result<FitPoints> fit_points_at(std::span<const Point> places, const FitForm& form) {
    FitPoints fit{.kind = form.kind, .parametrization = form.parametrization, .closed = form.closed};
    for (const Point place : places) fit.points.push_back({place});
    return reparametrized(std::move(fit));
}

Result<void> check_fit_points(const FitPoints& fit) {
    if (const auto check = check_parameters(places_of(fit), fit.parameters, fit.closed); !check) return check;
    const bool handles_are_finite =
        std::ranges::all_of(fit.points, [](const FitPoint& point) { return is_finite(point.handle); });
    if (!handles_are_finite) return refuse({.code = CurveErrorCode::vector_not_finite});
    return {};
}

Result<FitPoints> move_fit_point(const FitPoints& fit, std::size_t i, Point place) {
    if (const auto check = check_index(fit, i); !check) return refuse(check.error());
    if (!is_finite(place)) return refuse({.code = CurveErrorCode::data_point_not_finite, .index = i});
    FitPoints moved = fit;
    moved.points[i].place = place;
    return fit.kind == FitKind::local ? with_near_parameter(std::move(moved), i, fit)
                                      : reparametrized(std::move(moved));
}

Result<FitPoints> insert_fit_point(const FitPoints& fit, std::size_t i, Point place) {
    if (i > fit.points.size()) return refuse(check_index(fit, i).error());
    if (!is_finite(place)) return refuse({.code = CurveErrorCode::data_point_not_finite, .index = i});
    const std::size_t at = fit.closed && i == 0 ? fit.points.size() : i;
    const bool parts_line = at > 0 && (fit.closed || at < fit.points.size()) && is_straight(fit.points[at - 1].joint);
    FitPoints longer = fit;
    longer.points.insert(longer.points.begin() + static_cast<std::ptrdiff_t>(at),
                         {place, parts_line ? FitJoint::straight : FitJoint::smooth});
    return fit.kind == FitKind::local ? with_new_parameter(std::move(longer), at) : reparametrized(std::move(longer));
}

Result<FitPoints> delete_fit_point(const FitPoints& fit, std::size_t i) {
    if (const auto check = check_index(fit, i); !check) return refuse(check.error());
    FitPoints shorter = fit;
    shorter.points.erase(shorter.points.begin() + static_cast<std::ptrdiff_t>(i));
    if (const auto check = check_places(places_of(shorter), fit.closed); !check) return refuse(check.error());
    if (fit.kind != FitKind::local) return reparametrized(std::move(shorter));
    shorter.parameters.erase(shorter.parameters.begin() + static_cast<std::ptrdiff_t>(i));
    if (fit.closed && i == 0) shorter.parameters.back() += fit.parameters[1] - fit.parameters[0];
    return shorter;
}

Result<FitPoints> set_fit_joint(const FitPoints& fit, std::size_t i, FitJoint joint, Vector handle) {
    if (const auto check = check_index(fit, i); !check) return refuse(check.error());
    if (!is_finite(handle)) return refuse({.code = CurveErrorCode::vector_not_finite});
    FitPoints changed = fit;
    changed.points[i].joint = joint;
    changed.points[i].handle = joint == FitJoint::tangent ? handle : Vector{};
    return changed;
}

Result<FitPoints> set_fit_form(const FitPoints& fit, const FitForm& form) {
    FitPoints changed = fit;
    changed.kind = form.kind;
    changed.parametrization = form.parametrization;
    changed.closed = form.closed;
    return reparametrized(std::move(changed));
}

double span_beside(const FitPoints& fit, std::size_t i) {
    const std::vector<double>& u = fit.parameters;
    const std::size_t last = fit.points.size() - 1;
    if (!fit.closed && i == 0) return u[1] - u[0];
    if (!fit.closed && i == last) return u[last] - u[last - 1];
    const double way_in = i == 0 ? u[last + 1] - u[last] : u[i] - u[i - 1];
    return 0.5 * (way_in + (u[i + 1] - u[i]));
}

Vector derivative_of_handle(const FitPoints& fit, std::size_t i) {
    return 3.0 / span_beside(fit, i) * fit.points[i].handle;
}

Vector handle_of_derivative(const FitPoints& fit, std::size_t i, Vector derivative) {
    return span_beside(fit, i) / 3.0 * derivative;
}

}  // namespace batten::core
