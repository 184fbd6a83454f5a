#include "core/make/fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/detail/gauss_rule.h"
#include "core/curve/detail/edit_checks.h"
#include "core/make/detail/directed.h"
#include "core/make/detail/end_conditions.h"
#include "core/make/detail/fit_errors.h"

namespace batten::core {

namespace {

constexpr std::size_t spans_of_first_closed_fit = 3;

Ends reversed(const Ends& ends) {
    const auto* tangents = std::get_if<EndTangents>(&ends);
    if (tangents == nullptr) return ends;
    const auto negative = [](const std::optional<Vector>& tangent) {
        return tangent ? std::optional(-*tangent) : std::nullopt;
    };
    return EndTangents{negative(tangents->end), negative(tangents->start)};
}

struct DirectedData {
    std::vector<Point> points;
    FitRequest request;
    bool is_reversed = false;
};

DirectedData directed(std::span<const Point> points, const FitRequest& request) {
    DirectedData data{
        {points.begin(), points.end()}, request, !is_canonical(is_closed(request.ends) ? points.subspan(1) : points)};
    if (!data.is_reversed) return data;
    std::reverse(data.points.begin() + (is_closed(request.ends) ? 1 : 0), data.points.end());
    data.request.ends = reversed(request.ends);
    return data;
}

// A curve and how far each point is from it, at its own parameter.
struct Fit {
    Curve curve;
    std::vector<double> errors;

    double error() const { return *std::max_element(errors.begin(), errors.end()); }
};

class Fitter {
  public:
    Fitter(DirectedData data, std::vector<double> parameters, Progress progress)
        : progress_(std::move(progress)),
          points_(std::move(data.points)),
          request_(data.request),
          parameters_(std::move(parameters)),
          p_(static_cast<std::size_t>(request_.degree)),
          is_closed_(is_closed(request_.ends)),
          needs_(needs_of(request_.ends)),
          is_reversed_(data.is_reversed) {}

    std::size_t least_count() const {
        if (is_closed_) return 2;
        return std::max(p_ + 1, 2 + needs_.count());
    }

    std::size_t most_count() const { return points_.size() + needs_.count(); }

    Result<void> check_point_count() const {
        if (most_count() >= least_count()) return {};
        return refuse({.code = CurveErrorCode::data_points_too_few,
                       .value = static_cast<double>(points_.size()),
                       .lower = static_cast<double>(least_count() - needs_.count())});
    }

    Result<Approximation> with_count(std::size_t count) {
        if (count < least_count())
            return refuse({.code = CurveErrorCode::too_few_points,
                           .value = static_cast<double>(count),
                           .lower = static_cast<double>(least_count())});
        if (count > most_count())
            return refuse({.code = CurveErrorCode::control_points_too_many,
                           .value = static_cast<double>(count),
                           .upper = static_cast<double>(most_count())});
        return over(even_breaks(count)).map([&](Fit found) { return in_given_direction(std::move(found)); });
    }

    Result<Approximation> within(double tolerance) {
        round_.length = 0.5;
        std::vector<double> breaks = even_breaks(first_count());
        Result<Fit> best = over(breaks);
        // Breaks where they are needed may be more than the points determine; evenly there may be as many as points.
        while (best && best->error() > tolerance && refine(breaks, best->errors, tolerance)) {
            round_ = {round_.begin + round_.length, 0.5 * round_.length};
            Result<Fit> finer = over(breaks);
            if (!finer) break;
            best = std::move(finer);
        }
        if (best && best->error() > tolerance) {
            Result<Fit> through_all = over(even_breaks(most_count()));
            if (through_all && through_all->error() < best->error()) best = std::move(through_all);
        }
        if (best && best->error() > tolerance)
            return refuse({.code = CurveErrorCode::tolerance_not_reached, .value = tolerance, .lower = best->error()});
        return best.map([&](Fit found) { return in_given_direction(std::move(found)); });
    }

  private:
    bool is_natural() const { return std::holds_alternative<NaturalEnds>(request_.ends); }

    std::size_t step_count() const { return parameters_.size() - 1; }

    std::size_t first_count() const {
        return is_closed_ ? std::min(spans_of_first_closed_fit, points_.size()) : least_count();
    }

    // Places are counted in points: 2.5 is midway between points 2 and 3. These are so many, evenly from one end to the
    // other, and symmetric to the last bit.
    std::vector<double> even_places(std::size_t count) const {
        const std::size_t steps = step_count();
        const std::size_t last = count - 1;
        std::vector<double> places(count);
        for (std::size_t k = 0; k <= last; ++k)
            places[k] = static_cast<double>(k * steps / last) +
                        static_cast<double>(k * steps % last) / static_cast<double>(last);
        return places;
    }

    // The breaks between spans for `count` control points. Each is the mean of p sites, as in interpolation, so that no
    // part of the curve has more control points than points to determine it. Of even degree a closed curve has them
    // half a span later, because knots at the parameters may leave it undetermined.
    std::vector<double> even_breaks(std::size_t count) const {
        if (is_closed_) {
            std::vector<double> breaks = even_places(count + 1);
            if (p_ % 2 == 0)
                for (double& at : breaks) at -= 0.5 * static_cast<double>(step_count()) / static_cast<double>(count);
            return breaks;
        }
        std::vector<double> sites = even_places(count - needs_.count());
        // A natural cubic spline has its breaks at the points.
        if (is_natural() && p_ == 3) return sites;
        sites.insert(sites.begin(), needs_.at_start, sites.front());
        sites.insert(sites.end(), needs_.at_end, sites.back());
        const std::vector<double> knots = averaged_knots(sites, p_);
        return {knots.begin() + static_cast<std::ptrdiff_t>(p_), knots.end() - static_cast<std::ptrdiff_t>(p_)};
    }

    // How many points a span must be long: one, and at the ends as many as averaged knots leave there.
    double least_length(std::size_t span, std::size_t span_count) const {
        if (is_closed_) return 1.0;
        const double at_end = 0.5 * static_cast<double>(p_ + 1);
        double least = 1.0;
        if (span == 0) least = std::max(least, at_end - static_cast<double>(needs_.at_start));
        if (span + 1 == span_count) least = std::max(least, at_end - static_cast<double>(needs_.at_end));
        return least;
    }

    // Where in the domain the place `at` is, continued periodically.
    double parameter_at(double at) const {
        const auto steps = static_cast<double>(step_count());
        const double turns = is_closed_ ? std::floor(at / steps) : 0.0;
        at -= turns * steps;
        const double whole = std::min(std::floor(at), steps - 1.0);
        const auto k = static_cast<std::size_t>(whole);
        return turns + parameters_[k] + (at - whole) * (parameters_[k + 1] - parameters_[k]);
    }

    // What is added to the parameters so that the period begins at 0.
    double shift_of(const std::vector<double>& breaks) const { return -parameter_at(breaks.front()); }

    Result<KnotVector> knots_for(const std::vector<double>& breaks) const {
        std::vector<double> knots(is_closed_ ? 1 : p_ + 1, 0.0);
        const double shift = shift_of(breaks);
        for (std::size_t j = 1; j + 1 < breaks.size(); ++j)
            knots.push_back(reversible(parameter_at(breaks[j]) + shift));
        knots.insert(knots.end(), is_closed_ ? 1 : p_ + 1, 1.0);
        return is_closed_ ? KnotVector::make_periodic(request_.degree, std::move(knots), KnotKind::periodic)
                          : KnotVector::make(request_.degree, std::move(knots), KnotKind::clamped_uniform);
    }

    EndPoints fixed_points(const KnotVector& knots) const {
        if (is_closed_) return {};
        return end_points(points_.front(), points_.back(), request_.ends, knots);
    }

    void require_points(SplineSystem& system, double shift) const {
        const std::size_t first = is_closed_ ? 0 : 1;
        for (std::size_t k = first; k + first < points_.size(); ++k) {
            system.require_point(parameters_[k] + shift, points_[k]);
            tell_point(k);
        }
    }

    void require_smoothness(SplineSystem& system) const {
        if (request_.smoothing == 0.0) return;
        const int order = std::min({request_.penalized_derivative, request_.degree, 3});
        const auto rule = gauss_rule(p_ - static_cast<std::size_t>(order) + 1);
        const KnotVector& knots = system.knots();
        for (std::size_t s = p_; s + p_ + 1 < knots.size(); ++s) {
            const double half = 0.5 * (knots[s + 1] - knots[s]);
            for (const GaussNode& node : rule)
                system.require_derivative(knots[s] + half * (1.0 + node.position), order, Vector{},
                                          std::sqrt(request_.smoothing * half * node.weight));
        }
    }

    Result<Fit> over(const std::vector<double>& breaks) const {
        auto knots = knots_for(breaks);
        if (!knots) return refuse(knots.error());
        SplineSystem system(*knots, points_.front(), fixed_points(*knots));
        require_points(system, shift_of(breaks));
        require_smoothness(system);
        auto points = system.solve();
        if (!points) return refuse({.code = CurveErrorCode::equations_singular});
        if (!is_closed_) {
            points->front() = points_.front();
            points->back() = points_.back();
        }
        auto curve = Curve::make(*std::move(knots), *std::move(points), {});
        if (!curve) return refuse(curve.error());
        std::vector<double> errors = fit_errors(*curve, points_, parameters_, shift_of(breaks));
        if (!std::ranges::all_of(errors, [](double error) { return std::isfinite(error); }))
            return refuse({.code = CurveErrorCode::not_computable});
        return Fit{*std::move(curve), std::move(errors)};
    }

    // Tells that point k of the round is dealt with.
    void tell_point(std::size_t k) const {
        constexpr std::size_t points_between = 4096;
        if (!progress_ || k % points_between != 0) return;
        const double part = static_cast<double>(k) / static_cast<double>(points_.size());
        progress_(round_.begin + round_.length * part);
    }

    // Which spans contain a point with a larger error than allowed; a point at a break is in both of its spans.
    std::vector<char> bad_spans(const std::vector<double>& breaks, std::span<const double> errors,
                                double tolerance) const {
        std::vector<char> is_bad(breaks.size() - 1, 0);
        for (std::size_t k = 0; k < points_.size(); ++k) {
            if (!(errors[k] > tolerance)) continue;
            auto at = static_cast<double>(k);
            if (is_closed_ && at > breaks.back()) at -= static_cast<double>(step_count());
            const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, at);
            const auto span = static_cast<std::size_t>(above - breaks.begin()) - 1;
            is_bad[span] = 1;
            if (breaks[span] == at && span > 0) is_bad[span - 1] = 1;
        }
        return is_bad;
    }

    // More breaks where the errors are too large; whether there is room for any.
    bool refine(std::vector<double>& breaks, std::span<const double> errors, double tolerance) const {
        const std::vector<char> is_bad = bad_spans(breaks, errors, tolerance);
        return halve(breaks, is_bad) || divide_evenly(breaks, is_bad);
    }

    // Halves the bad spans that are long enough for points on both sides.
    bool halve(std::vector<double>& breaks, const std::vector<char>& is_bad) const {
        std::vector<double> finer{breaks.front()};
        for (std::size_t j = 0; j < is_bad.size(); ++j) {
            const double half = 0.5 * (breaks[j + 1] - breaks[j]);
            if (is_bad[j] != 0 && half >= least_length(j, is_bad.size())) finer.push_back(breaks[j] + half);
            finer.push_back(breaks[j + 1]);
        }
        return take_if_finer(breaks, std::move(finer));
    }

    // Divides runs of bad spans, and one on either side, into spans of little more than one point each; the end spans
    // of an open curve stay.
    bool divide_evenly(std::vector<double>& breaks, const std::vector<char>& is_bad) const {
        const std::size_t spans = is_bad.size();
        const std::size_t margin = is_closed_ ? 0 : 1;
        const auto takes_part = [&](std::size_t j) {
            if (j < margin || j + margin >= spans) return false;
            return is_bad[j] != 0 || (j > 0 && is_bad[j - 1] != 0) || (j + 1 < spans && is_bad[j + 1] != 0);
        };
        std::vector<double> finer{breaks.front()};
        for (std::size_t j = 0; j < spans;) {
            std::size_t end = j;
            while (end < spans && takes_part(end)) ++end;
            const double length = breaks[end] - breaks[j];
            const auto parts = static_cast<std::size_t>(length);
            if (parts > end - j) {
                for (std::size_t k = 1; k <= parts; ++k)
                    finer.push_back(k == parts
                                        ? breaks[end]
                                        : breaks[j] + length * static_cast<double>(k) / static_cast<double>(parts));
                j = end;
            } else {
                end = std::max(end, j + 1);
                for (; j < end; ++j) finer.push_back(breaks[j + 1]);
            }
        }
        return take_if_finer(breaks, std::move(finer));
    }

    static bool take_if_finer(std::vector<double>& breaks, std::vector<double> finer) {
        if (finer.size() == breaks.size()) return false;
        breaks = std::move(finer);
        return true;
    }

    Approximation in_given_direction(Fit found) const {
        const double error = found.error();
        return {is_reversed_ ? reversed(found.curve) : std::move(found.curve), error};
    }

    // The share of the whole that the present round is. How many there will be is not known: each is half of what is
    // left.
    struct Round {
        double begin = 0.0;
        double length = 1.0;
    };

    Progress progress_;
    Round round_{};
    std::vector<Point> points_;
    FitRequest request_;
    std::vector<double> parameters_;
    std::size_t p_;
    bool is_closed_;
    EndNeeds needs_;
    bool is_reversed_;
};

Result<Fitter> make_fitter(std::span<const Point> points, FitRequest request, const Progress& progress) {
    assert(request.penalized_derivative == 2 || request.penalized_derivative == 3);
    if (const auto check = check_degree(request.degree); !check) return refuse(check.error());
    if (const auto check = check_degree_of_ends(request.ends, request.degree); !check) return refuse(check.error());
    // First in the direction given, so that a refusal names the point as it was given.
    if (const auto given = parametrize(points, request.parametrization, is_closed(request.ends)); !given)
        return refuse(given.error());
    if (!(request.smoothing >= 0.0) || !std::isfinite(request.smoothing))
        return refuse({.code = CurveErrorCode::smoothing_negative, .value = request.smoothing});
    if (const auto check = check_tangents(request.ends); !check) return refuse(check.error());
    DirectedData data = directed(points, request);
    auto parameters = parametrize(data.points, request.parametrization, is_closed(request.ends));
    if (!parameters) return refuse(parameters.error());
    Fitter fitter(std::move(data), *std::move(parameters), progress);
    if (auto enough = fitter.check_point_count(); !enough) return refuse(enough.error());
    return fitter;
}

}  // namespace

Result<Approximation> fit(std::span<const Point> points, std::size_t count, const FitRequest& request,
                          const Progress& progress) {
    return make_fitter(points, request, progress).and_then([&](Fitter fitter) { return fitter.with_count(count); });
}

Result<Approximation> fit_within(std::span<const Point> points, double tolerance, const FitRequest& request,
                                 const Progress& progress) {
    return make_fitter(points, request, progress).and_then([&](Fitter fitter) -> Result<Approximation> {
        if (const auto check = check_tolerance(tolerance); !check) return refuse(check.error());
        return fitter.within(tolerance);
    });
}

}  // namespace batten::core
