#include "core/make/fit_stroke.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/evaluate/evaluate.h"
#include "core/make/detail/calm_polygon.h"
#include "core/make/detail/directed.h"
#include "core/make/detail/knots_by_need.h"
#include "core/make/detail/penalized_spline.h"
#include "core/make/detail/stroke_corners.h"
#include "core/make/detail/stroke_knots.h"
#include "core/make/detail/stroke_samples.h"

namespace batten::core {

namespace {

// All lengths are in pixels.
constexpr double span = 12.0;
constexpr double least_extent = 2.0;
constexpr double most_length = 1e9;

// At the usual smoothness knots are left out within the first, and the polygon moved by up to so many times that.
constexpr double usual_tolerance = 0.4;
constexpr double share_of_calming = 3.0;
constexpr double calming_before = 0.8;

// What one step of smoothness changes.
constexpr double tolerance_by_step = 1.515716566510398;  // the root of order 5/3 of 2
constexpr double lambda_by_step = 10.0;

// A third derivative below this bends a span by less than a hundredth of a pixel.
constexpr double least_third = 1e-4;
constexpr int rounds_of_stiffness = 2;

// Around each span in turn so many count for its stiffness, the less the farther.
constexpr std::ptrdiff_t reach_of_stiffness = 2;

// Almost none: for curves near others that are smooth already.
constexpr double lambda_of_copies = 1e-6;

class StrokeFitter {
  public:
    explicit StrokeFitter(Stroke stroke)
        : stroke_(std::move(stroke)),
          breaks_(even_breaks(stroke_, find_corners(stroke_), span)),
          span_(std::max(span, breaks_.length() / static_cast<double>(breaks_.stations.size()))) {
        for (StrokeSample& sample : stroke_.samples)
            if (sample.station < breaks_.stations.front()) sample.station += stroke_.length;
        std::ranges::stable_sort(stroke_.samples, {}, &StrokeSample::station);
    }

    /// The curve over [0, 1].
    Result<Curve> fitted(int smoothness) const {
        const double step = smoothness - usual_smoothness;
        const double tolerance = usual_tolerance * std::pow(tolerance_by_step, step);
        const auto knots = knots_over(breaks_);
        if (!knots) return refuse(knots.error());
        const auto smooth = smoothed(*knots, std::min(0.0, step));
        if (!smooth) return refuse(smooth.error());
        const std::vector<StrokeSample> samples = samples_of(smooth->usual);
        const StrokeBreaks needed = needed_breaks(smooth->usual, samples, tolerance);
        return copied(step < 0.0 ? samples_of(smooth->wanted) : samples, needed)
            .map([&](const Curve& curve) { return calmed(curve, share_of_calming * tolerance); })
            .and_then(over_unit_interval);
    }

    /// The smooth line from one station to another, every few pixels.
    std::vector<Point> line(double from, double to) const {
        const auto knots = knots_over(breaks_);
        const auto smooth = knots ? smoothed(*knots, 0.0) : refuse(knots.error());
        if (!smooth) return {};
        constexpr double step = 3.0;
        constexpr double most_steps = 10000.0;
        const double count = std::clamp(std::ceil((to - from) / step), 1.0, most_steps);
        std::vector<Point> points;
        for (double k = 0.0; k <= count; k += 1.0)
            points.push_back(point_at(smooth->usual, from + (to - from) * k / count));
        return points;
    }

  private:
    // The curve of all spans as smooth as cross-validation says, and truer by so many steps.
    struct Smoothed {
        Curve usual;
        Curve wanted;
    };

    Result<Smoothed> smoothed(const KnotVector& knots, double step) const {
        Stiffness stiffness;
        for (int round = 0;; ++round) {
            const PenalizedSpline equations(knots, stroke_.samples, span_, stiffness);
            const double lambda = equations.best_lambda();
            const auto usual = curve_over(knots, equations.solve(lambda));
            if (!usual) return refuse(usual.error());
            if (round < rounds_of_stiffness) {
                stiffness = stiffness_of(*usual);
                continue;
            }
            const auto wanted = curve_over(knots, equations.solve(lambda * std::pow(lambda_by_step, step)));
            if (!wanted) return refuse(wanted.error());
            return Smoothed{calmed(*usual, calming_before), *wanted};
        }
    }

    static Result<Curve> curve_over(const KnotVector& knots, const std::optional<std::vector<Vector>>& places) {
        if (!places) return refuse({.code = CurveErrorCode::not_computable});
        std::vector<Point> points;
        for (const Vector& place : *places) points.push_back(tip_of(place));
        return Curve::make(knots, std::move(points), {});
    }

    // The penalty counts less where the curve bends more sharply than elsewhere.
    Stiffness stiffness_of(const Curve& curve) const {
        const std::vector<double>& stations = breaks_.stations;
        std::vector<double> squares;
        for (std::size_t k = 1; k < stations.size(); ++k) {
            const Vector third = derivatives_at(curve, 0.5 * (stations[k - 1] + stations[k]), 3)[3];
            squares.push_back(dot(third, third));
        }
        const auto n = static_cast<std::ptrdiff_t>(squares.size());
        Stiffness found;
        for (std::ptrdiff_t k = 0; k < n; ++k) {
            double sum = 0.0;
            double weights = 0.0;
            for (std::ptrdiff_t j = -reach_of_stiffness; j <= reach_of_stiffness; ++j) {
                const std::ptrdiff_t i = breaks_.is_closed ? (k + j + reach_of_stiffness * n) % n : k + j;
                if (i < 0 || i >= n) continue;
                const double weight = 1.0 / static_cast<double>(1 + j * j);
                sum += weight * squares[static_cast<std::size_t>(i)];
                weights += weight;
            }
            constexpr double unit = 1e-6;
            found.push_back(
                {stations[static_cast<std::size_t>(k) + 1], unit / (sum / weights + least_third * least_third)});
        }
        return found;
    }

    // Several on each span, from which another curve can be made that is the same.
    std::vector<StrokeSample> samples_of(const Curve& curve) const {
        std::vector<StrokeSample> samples;
        const auto add = [&](double station, Side side) {
            samples.push_back({.station = station, .place = vector_to(point_at(curve, station, side))});
        };
        for (std::size_t k = 1; k < breaks_.stations.size(); ++k)
            for (const double share : {0.0, 1.0 / 3.0, 2.0 / 3.0})
                add(breaks_.stations[k - 1] + share * (breaks_.stations[k] - breaks_.stations[k - 1]), Side::right);
        add(breaks_.stations.back(), Side::left);
        return samples;
    }

    Result<Curve> copied(std::span<const StrokeSample> samples, const StrokeBreaks& breaks) const {
        const auto knots = knots_over(breaks);
        if (!knots) return refuse(knots.error());
        return curve_over(*knots, PenalizedSpline(*knots, samples, span_).solve(lambda_of_copies));
    }

    // As few breaks as leave a curve within the tolerance. They are left out in one order, and halving asks the same
    // questions for every tolerance, so that a larger one never leaves more.
    StrokeBreaks needed_breaks(const Curve& curve, std::span<const StrokeSample> samples, double tolerance) const {
        const std::vector<double> order = knots_by_need(curve);
        std::vector<Vector> normals;
        for (const StrokeSample& sample : samples) {
            const Vector way = derivatives_at(curve, sample.station, 1)[1];
            const double speed = length(way);
            normals.push_back(speed > 0.0 ? turned_left(way) / speed : Vector{});
        }
        const auto is_near = [&](const StrokeBreaks& breaks) {
            const auto copy = copied(samples, breaks);
            if (!copy) return false;
            for (std::size_t k = 0; k < samples.size(); ++k) {
                const Vector error = vector_to(point_at(*copy, samples[k].station)) - samples[k].place;
                if (!(std::abs(dot(error, normals[k])) <= tolerance)) return false;
            }
            return true;
        };
        const auto without_first = [&](std::size_t count) {
            return without(breaks_, {order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count)});
        };
        const std::size_t kept = breaks_.is_closed ? 3 : 0;
        std::size_t low = 0;
        std::size_t high = order.size() - std::min(order.size(), kept);
        while (low < high) {
            const std::size_t middle = (low + high + 1) / 2;
            if (is_near(without_first(middle)))
                low = middle;
            else
                high = middle - 1;
        }
        return without_first(low);
    }

    // Without bends to the wrong side between the ends and corners.
    static Curve calmed(const Curve& curve, double tolerance) {
        std::vector<Point> points(curve.control_points().begin(), curve.control_points().end());
        const std::size_t n = points.size();
        const std::vector<std::size_t> fixed = fixed_points(curve);
        for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
            std::vector<Point> part;
            for (std::size_t i = fixed[k]; i <= fixed[k + 1]; ++i) part.push_back(points[i % n]);
            calm_polygon(part, tolerance);
            for (std::size_t i = fixed[k] + 1; i < fixed[k + 1]; ++i) points[i % n] = part[i - fixed[k]];
        }
        return Curve::make(curve.knots(), std::move(points), {}).value();
    }

    // The control points at ends and corners, ascending and once around; of a smooth closed curve the one with the
    // largest turn.
    static std::vector<std::size_t> fixed_points(const Curve& curve) {
        const KnotVector& knots = curve.knots();
        const std::size_t n = curve.control_points().size();
        std::vector<std::size_t> found;
        for (std::size_t i = 1; i + 2 < knots.size() && i - 1 < n; ++i)
            if (knots[i] == knots[i + 2] && knots[i - 1] != knots[i]) found.push_back(i - 1);
        if (!curve.is_periodic()) {
            found.insert(found.begin(), 0);
            found.push_back(n - 1);
            return found;
        }
        if (found.empty()) found.push_back(sharpest_point(curve.control_points()));
        found.push_back(found.front() + n);
        return found;
    }

    static std::size_t sharpest_point(std::span<const Point> points) {
        const std::size_t n = points.size();
        const auto turn = [&](std::size_t i) {
            return std::abs(cross(points[i] - points[(i + n - 1) % n], points[(i + 1) % n] - points[i]));
        };
        std::size_t sharpest = 0;
        for (std::size_t i = 1; i < n; ++i)
            if (turn(i) > turn(sharpest)) sharpest = i;
        return sharpest;
    }

    static Result<Curve> over_unit_interval(const Curve& curve) {
        CurveDefinition definition = curve.definition();
        const Interval domain = curve.domain();
        for (double& knot : definition.knots)
            knot = knot == domain.upper ? 1.0 : reversible((knot - domain.lower) / domain.length());
        return Curve::make(std::move(definition));
    }

    Stroke stroke_;
    StrokeBreaks breaks_;
    double span_;  ///< longer than usual where samples are far apart
};

Result<void> check_extent(std::span<const Point> points, double pixel) {
    Box box;
    for (const Point& point : points) box.include(point);
    const double extent = std::max(box.size().x, box.size().y) / pixel;
    if (extent >= least_extent) return {};
    return refuse({.code = CurveErrorCode::stroke_too_short, .value = extent, .lower = least_extent});
}

Result<void> check_stroke(std::span<const Point> points, double pixel) {
    if (points.empty()) return refuse({.code = CurveErrorCode::data_points_too_few, .value = 0.0, .lower = 1.0});
    for (std::size_t k = 0; k < points.size(); ++k)
        if (!is_finite(points[k])) return refuse({.code = CurveErrorCode::data_point_not_finite, .index = k});
    if (!(pixel > 0.0) || !std::isfinite(pixel))
        return refuse({.code = CurveErrorCode::length_not_positive, .value = pixel});
    return check_extent(points, pixel);
}

// The way up to the place of sample `index`.
double station_of(std::span<const Point> points, double pixel, std::size_t index) {
    return index == 0 ? 0.0 : stroke_through(points.first(index + 1), pixel, false).length;
}

}  // namespace

std::vector<Point> smooth_line(std::span<const Point> points, double pixel, std::size_t from, std::size_t to) {
    assert(from <= to && to < points.size());
    if (!check_stroke(points, pixel)) return {};
    Stroke stroke = stroke_through(points, pixel, false);
    if (!(stroke.length <= most_length)) return {};
    const bool is_at_end = to + 1 == points.size();
    const double first = std::min(station_of(points, pixel, from), stroke.length);
    const double last = is_at_end ? stroke.length : std::min(station_of(points, pixel, to), stroke.length);
    // The line ends where the pen is.
    constexpr double weight_of_end = 100.0;
    stroke.samples.back().weight = weight_of_end;
    std::vector<Point> line = StrokeFitter(std::move(stroke)).line(first, std::max(first, last));
    for (Point& point : line) point = points.front() + pixel * vector_to(point);
    if (is_at_end && !line.empty()) line.push_back(points.back());
    return line;
}

Result<Curve> fit_stroke(std::span<const Point> points, const StrokeRequest& request) {
    assert(least_smoothness <= request.smoothness && request.smoothness <= most_smoothness);
    if (const auto check = check_stroke(points, request.pixel); !check) return refuse(check.error());
    std::vector<Point> directed(points.begin(), points.end());
    const bool is_reversed = !is_canonical(points);
    if (is_reversed) std::ranges::reverse(directed);
    Stroke stroke = stroke_through(directed, request.pixel, request.may_close);
    if (!(stroke.length <= most_length)) return refuse({.code = CurveErrorCode::not_computable});
    auto curve = StrokeFitter(std::move(stroke)).fitted(request.smoothness);
    if (!curve) return curve;
    CurveDefinition definition = curve->definition();
    for (Point& point : definition.points) point = directed.front() + request.pixel * vector_to(point);
    return Curve::make(std::move(definition)).map([&](const Curve& found) {
        return is_reversed ? reversed(found) : found;
    });
}

}  // namespace batten::core
