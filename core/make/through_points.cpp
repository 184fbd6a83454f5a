#include "core/make/through_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/make/detail/fit_spans.h"
#include "core/make/detail/spline_run.h"
#include "core/make/interpolate.h"

namespace batten::core {

namespace {

constexpr int degree_of(FitKind kind) {
    return kind == FitKind::fair ? 5 : 3;
}

// A closed curve without a break anywhere.
Result<Curve> smooth_ring(const FitPoints& fit, const Progress& progress) {
    std::vector<Point> places;
    for (const FitPoint& point : fit.points) places.push_back(point.place);
    const InterpolationRequest request{
        .degree = degree_of(fit.kind), .ends = ClosedEnds{}, .parameters = fit.parameters};
    return interpolate(places, request, progress).map([](Interpolation result) { return std::move(result.curve); });
}

// Puts runs together. Points are counted from the first break on, so that a closed curve is one row of runs too.
class RunAssembly {
  public:
    RunAssembly(const FitPoints& fit, std::vector<JointNeeds> needs, std::size_t first)
        : fit_(fit), spans_(fit), needs_(std::move(needs)), first_(first) {}

    Result<Curve> curve(const Progress& progress) {
        points_.push_back(spans_.place(first_));
        const std::size_t end = first_ + spans_.count();
        for (std::size_t begin = first_; begin < end;) {
            std::size_t next = begin + 1;
            while (next < end && !need(next).is_break) ++next;
            if (const auto added = add_run(begin, next); !added) return refuse(added.error());
            begin = next;
            tell(progress, begin - first_, spans_.count());
        }
        if (!std::ranges::all_of(points_, [](Point point) { return is_finite(point); }))
            return refuse({.code = CurveErrorCode::not_computable});
        return fit_.closed ? closed_curve() : open_curve();
    }

  private:
    std::size_t p() const { return static_cast<std::size_t>(degree_of(fit_.kind)); }
    const JointNeeds& need(std::size_t i) const { return needs_[i % needs_.size()]; }

    double parameter(std::size_t i) const {
        const std::size_t n = spans_.point_count();
        return i < fit_.parameters.size() ? fit_.parameters[i]
                                          : fit_.parameters[i - n] + (fit_.parameters[n] - fit_.parameters[0]);
    }

    std::size_t multiplicity(std::size_t i) const {
        if (need(i).is_corner) return p();
        return need(i).is_break ? p() - 1 : 1;
    }

    // The run from one break to the next, which begins with the last point that there is.
    Result<void> add_run(std::size_t begin, std::size_t end) {
        places_.clear();
        parameters_.clear();
        for (std::size_t i = begin; i <= end; ++i) {
            places_.push_back(spans_.place(i));
            parameters_.push_back(parameter(i));
        }
        const SplineRun run{places_, parameters_, need(begin).right, need(end).left};
        Result<std::vector<Point>> found = p() == 3 ? cubic_run(run) : quintic_run(run);
        if (!found) return refuse(found.error());
        // What both sides of a joint have in common lies between its neighbors and takes no point of its own.
        if (begin > first_ && !need(begin).is_corner) points_.pop_back();
        points_.insert(points_.end(), found->begin() + 1, found->end());
        return {};
    }

    Result<Curve> open_curve() {
        std::vector<double> knots(p() + 1, parameter(0));
        for (std::size_t i = 1; i + 1 < spans_.point_count(); ++i)
            knots.insert(knots.end(), multiplicity(i), parameter(i));
        knots.insert(knots.end(), p() + 1, parameter(spans_.point_count() - 1));
        return KnotVector::make(static_cast<int>(p()), std::move(knots)).and_then([&](KnotVector vector) {
            return Curve::make(std::move(vector), std::move(points_), {});
        });
    }

    // Control point k of the unrolled curve belongs to the knots k-p+1 to k of the period, counted from 0.
    Result<Curve> closed_curve() {
        points_.pop_back();
        if (!need(first_).is_corner) points_.erase(points_.begin());
        std::vector<double> period;
        std::size_t first_knot = 0;
        for (std::size_t i = 0; i < spans_.point_count(); ++i) {
            if (i == first_) first_knot = period.size();
            period.insert(period.end(), multiplicity(i), parameter(i));
        }
        period.push_back(fit_.parameters.back());
        const std::size_t shift = (first_knot + p() - 1) % points_.size();
        std::rotate(points_.begin(), points_.end() - static_cast<std::ptrdiff_t>(shift), points_.end());
        return KnotVector::make_periodic(static_cast<int>(p()), std::move(period)).and_then([&](KnotVector vector) {
            return Curve::make(std::move(vector), std::move(points_), {});
        });
    }

    const FitPoints& fit_;
    FitSpans spans_;
    std::vector<JointNeeds> needs_;
    std::size_t first_;
    std::vector<Point> points_;
    std::vector<Point> places_;  // of one run, as are its parameters
    std::vector<double> parameters_;
};

}  // namespace

Result<Curve> through_points(const FitPoints& fit, const Progress& progress) {
    if (const auto check = check_fit_points(fit); !check) return refuse(check.error());
    const FitSpans spans(fit);
    std::vector<JointNeeds> needs(spans.point_count());
    for (std::size_t i = 0; i < needs.size(); ++i) needs[i] = spans.needs(i);
    const auto first = std::ranges::find_if(needs, &JointNeeds::is_break);
    if (first == needs.end()) return smooth_ring(fit, progress);
    const auto begin = static_cast<std::size_t>(first - needs.begin());
    return RunAssembly(fit, std::move(needs), begin).curve(progress);
}

}  // namespace batten::core
