#include "core/edit/offset.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/curve/detail/edit_checks.h"
#include "core/curve/knot_analysis.h"
#include "core/edit/detail/offset_error.h"
#include "core/edit/detail/offset_polygon.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

constexpr int samples_in_span = 16;
constexpr int most_offset_halvings = 40;
constexpr std::size_t most_spans = 20000;
constexpr double offset_noise_in_ulps = 64.0;

// Directions whose sine differs by less are one.
constexpr double least_turn = 1e-9;

// A point of the true offset, with its derivative by u.
struct OffsetPoint {
    Point point{};
    Vector derivative{};
};

// One end of a span of the result, with the derivatives of both sides.
struct Break {
    double u = 0.0;
    Point point{};
    Vector before{};
    Vector after{};
    bool is_smooth = true;  ///< both derivatives are one
};

double largest_coordinate(const Curve& curve) {
    double largest = 0.0;
    for (const Point& point : curve.control_points())
        largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    return largest;
}

class OffsetBuilder {
  public:
    OffsetBuilder(const Curve& curve, double distance, double tolerance, const Progress& progress)
        : progress_(progress),
          curve_(curve),
          distance_(distance),
          tolerance_(tolerance),
          noise_(offset_noise_in_ulps * std::numeric_limits<double>::epsilon() *
                 (largest_coordinate(curve) + std::abs(distance))) {}

    Result<Approximation> build() {
        if (auto check = check_corners(); !check) return refuse(check.error());
        if (auto exact = circular()) return *std::move(exact);
        // Halving on would only chase rounding.
        if (tolerance_ < noise_)
            return refuse_computed(
                {.code = CurveErrorCode::tolerance_not_reached, .value = tolerance_, .lower = noise_});
        if (auto check = collect_breaks(); !check) return refuse(check.error());
        auto result = assembled();
        if (!result) return refuse(result.error());
        if (const auto sampled = error_of(*result, part_of(progress_, 0.6, 0.9)); !sampled)
            return refuse(sampled.error());
        const double error = offset_error_bound(curve_, *result, distance_);
        if (!(error <= tolerance_))
            return refuse_computed(
                {.code = CurveErrorCode::tolerance_not_reached, .value = tolerance_, .lower = error});
        return Approximation{*std::move(result), error};
    }

  private:
    Result<OffsetPoint> true_offset(double u, Side side) const {
        const auto curvature = curvature_at(curve_, u, side);
        if (!curvature) return refuse({.code = CurveErrorCode::curve_stands_still, .value = u});
        const auto derivatives = derivatives_at(curve_, u, 1, side);
        const double stretch = 1.0 - distance_ * *curvature;
        if (!(stretch > 0.0))
            return refuse({.code = CurveErrorCode::offset_too_far,
                           .value = u,
                           .lower = 1.0 / std::abs(*curvature),
                           .upper = std::abs(distance_)});
        const Vector tangent = derivatives[1] / robust_length(derivatives[1]);
        return OffsetPoint{derivatives.point + distance_ * turned_left(tangent), stretch * derivatives[1]};
    }

    // The ends of non-empty spans, ascending.
    std::vector<double> span_ends() const {
        const auto p = static_cast<std::size_t>(curve_.degree());
        const KnotVector& knots = curve_.knots();
        std::vector<double> ends;
        for (std::size_t i = p; i + p < knots.size(); ++i)
            if (ends.empty() || knots[i] != ends.back()) ends.push_back(knots[i]);
        return ends;
    }

    Result<void> check_corner(double u) const {
        const auto before = derivatives_at(curve_, u, 1, Side::left);
        const auto after = derivatives_at(curve_, u, 1, Side::right);
        const double sizes = length(before[1]) * length(after[1]);
        if (!(sizes > 0.0)) return refuse({.code = CurveErrorCode::curve_stands_still, .value = u});
        const bool is_bent =
            std::abs(cross(before[1], after[1])) > least_turn * sizes || dot(before[1], after[1]) < 0.0;
        if (is_bent || distance(before.point, after.point) > noise_)
            return refuse({.code = CurveErrorCode::curve_has_corner, .value = u});
        return {};
    }

    Result<void> check_corners() const {
        const auto ends = span_ends();
        for (std::size_t k = curve_.is_periodic() ? 0 : 1; k + 1 < ends.size(); ++k)
            if (auto check = check_corner(ends[k]); !check) return check;
        return {};
    }

    // The largest distance of `candidate` from the true offset over samples of its spans, or why there is no offset.
    Result<double> error_of(const Curve& candidate, const Progress& progress) const {
        const auto p = static_cast<std::size_t>(candidate.degree());
        const KnotVector& knots = candidate.knots();
        double largest = 0.0;
        for (std::size_t s = p; s + p + 1 < knots.size(); ++s) {
            tell(progress, s - p, knots.size());
            if (knots[s] == knots[s + 1]) continue;
            for (int k = 0; k <= samples_in_span; ++k) {
                const bool is_last = k == samples_in_span;
                const double u = is_last ? knots[s + 1] : knots[s] + (knots[s + 1] - knots[s]) * k / samples_in_span;
                const Side side = is_last ? Side::left : Side::right;
                const auto expected = true_offset(u, side);
                if (!expected) return refuse(expected.error());
                largest = std::max(largest, distance(expected->point, point_at(candidate, u, side)));
            }
        }
        return largest;
    }

    // The offset as it would be if the curve were all of the line or circle that it begins as: the control points are
    // moved, or scaled about the center. Taken where it is right.
    std::optional<Approximation> circular() const {
        const double u = curve_.domain().lower;
        const auto start = true_offset(u, Side::right);
        const auto curvature = curvature_at(curve_, u, Side::right);
        if (!start || !curvature) return std::nullopt;
        const Point origin = point_at(curve_, u);
        const Vector move = start->point - origin;
        CurveDefinition definition = curve_.definition();
        // C + d N + (-d k) (P - C) is C' + (1 - d k) (P - C') seen from the center, written without it for k near 0.
        for (Point& point : definition.points) point += move - distance_ * *curvature * (point - origin);
        const auto candidate = Curve::make(std::move(definition));
        if (!candidate) return std::nullopt;
        const auto error = error_of(*candidate, part_of(progress_, 0.0, 0.3));
        if (!error || *error > std::min(noise_, tolerance_)) return std::nullopt;
        return Approximation{*candidate, *error};
    }

    Result<void> collect_breaks() {
        const auto ends = span_ends();
        const Progress progress = part_of(progress_, 0.3, 0.6);
        for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
            tell(progress, k, ends.size());
            const auto start = true_offset(ends[k], Side::right);
            const auto end = true_offset(ends[k + 1], Side::left);
            if (!start || !end) return refuse(!start ? start.error() : end.error());
            if (breaks_.empty()) breaks_.push_back({ends[k], start->point, start->derivative, start->derivative});
            breaks_.back().after = start->derivative;
            if (auto check = add_span(ends[k], *start, ends[k + 1], *end, 0); !check) return check;
        }
        if (curve_.is_periodic()) breaks_.front().before = breaks_.back().before;
        for (Break& at : breaks_) {
            constexpr double least_jump = 1e-12;
            at.is_smooth = length(at.after - at.before) <= least_jump * length(at.after);
        }
        return {};
    }

    // Adds the end of the span, and breaks inside it where Hermite's cubic is not near enough.
    Result<void> add_span(double lower, const OffsetPoint& start, double upper, const OffsetPoint& end, int depth) {
        const auto near = is_near(lower, start, upper, end);
        if (!near) return refuse(near.error());
        const double middle = lower + 0.5 * (upper - lower);
        const bool is_divisible = depth < most_offset_halvings && lower < middle && middle < upper;
        if (*near || !is_divisible) {
            if (breaks_.size() > most_spans)
                return refuse_computed(
                    {.code = CurveErrorCode::tolerance_not_reached, .value = tolerance_, .lower = worst_});
            breaks_.push_back({upper, end.point, end.derivative, end.derivative});
            return {};
        }
        const auto half = true_offset(middle, Side::right);
        if (!half) return refuse(half.error());
        return add_span(lower, start, middle, *half, depth + 1).and_then([&] {
            return add_span(middle, *half, upper, end, depth + 1);
        });
    }

    Result<bool> is_near(double lower, const OffsetPoint& start, double upper, const OffsetPoint& end) {
        // Half of the tolerance is left to what lies between the samples and to rounding.
        const double allowed = std::max(0.5 * tolerance_, noise_);
        const double third = (upper - lower) / 3.0;
        const Vector a = third * start.derivative;
        const Vector b = end.point - third * end.derivative - start.point;
        const Vector c = end.point - start.point;
        for (int k = 1; k < samples_in_span; ++k) {
            const double t = static_cast<double>(k) / samples_in_span;
            const auto expected = true_offset(lower + t * (upper - lower), Side::right);
            if (!expected) return refuse(expected.error());
            const Point hermite =
                start.point + 3.0 * t * (1.0 - t) * (1.0 - t) * a + 3.0 * t * t * (1.0 - t) * b + t * t * t * c;
            const double error = distance(hermite, expected->point);
            if (error > allowed) {
                worst_ = std::max(tolerance_, error);
                return false;
            }
        }
        return true;
    }

    // Breaks as often as they are knots: twice where the derivative is one, three times elsewhere; ends p+1 = 4 times.
    std::vector<std::size_t> breaks_of_knots() const {
        std::vector<std::size_t> list;
        const std::size_t last = breaks_.size() - 1;
        for (std::size_t b = 0; b <= last; ++b) {
            const bool is_end = b == 0 || b == last;
            std::size_t times = breaks_[b].is_smooth ? 2 : 3;
            if (is_end && !curve_.is_periodic()) times = 4;
            // The seam is named once at its upper end.
            if (b == last && curve_.is_periodic()) times = 1;
            list.insert(list.end(), times, b);
        }
        return list;
    }

    // The control point whose knots are these three breaks; of a periodic curve counted on from turn to turn.
    Point control_point(std::size_t first, std::size_t second, std::size_t third) const {
        const std::size_t turn = breaks_.size() - 1;
        const auto place = [&](std::size_t b) { return curve_.is_periodic() ? b % turn : b; };
        if (first == third) return breaks_[place(first)].point;
        if (first == second) {
            const Break& at = breaks_[place(first)];
            return at.point + (breaks_[place(first) + 1].u - at.u) / 3.0 * at.after;
        }
        const std::size_t to = place(third) == 0 ? turn : place(third);
        return breaks_[to].point - (breaks_[to].u - breaks_[to - 1].u) / 3.0 * breaks_[to].before;
    }

    Result<Curve> assembled() const {
        const std::vector<std::size_t> list = breaks_of_knots();
        std::vector<double> knots;
        for (const std::size_t b : list) knots.push_back(breaks_[b].u);
        const std::size_t n = curve_.is_periodic() ? knots.size() - 1 : knots.size() - 4;
        const std::size_t turn = breaks_.size() - 1;
        // Knot j of the unrolled vector, whose period begins at knot 3, as a break; one turn is added to stay above 0.
        const auto break_of = [&](std::size_t j) {
            if (!curve_.is_periodic()) return list[j];
            const std::size_t from_start = j + n * 3 - 3;
            return list[from_start % n] + from_start / n * turn;
        };
        CurveDefinition definition{
            .degree = 3, .knots = std::move(knots), .points = {}, .periodic = curve_.is_periodic()};
        for (std::size_t i = 0; i < n; ++i)
            definition.points.push_back(control_point(break_of(i + 1), break_of(i + 2), break_of(i + 3)));
        return Curve::make(std::move(definition));
    }

    const Progress& progress_;
    const Curve& curve_;
    double distance_;
    double tolerance_;
    double noise_;
    double worst_ = 0.0;  ///< the error that was last found too large
    std::vector<Break> breaks_;
};

}  // namespace

Result<Approximation> offset(const Curve& curve, double distance, double tolerance, const Progress& progress) {
    if (!std::isfinite(distance)) return refuse({.code = CurveErrorCode::vector_not_finite});
    if (const auto check = check_tolerance(tolerance); !check) return refuse(check.error());
    if (distance == 0.0) return Approximation{curve, 0.0};
    if (curve.degree() == 1 && !curve.is_torn()) return offset_polygon(curve, distance);
    return OffsetBuilder(curve, distance, tolerance, progress).build();
}

}  // namespace batten::core
