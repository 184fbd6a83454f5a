#include "core/edit/offset.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/curve/detail/edit_checks.h"
#include "core/curve/knot_analysis.h"
#include "core/edit/detail/offset_error.h"
#include "core/edit/detail/offset_polygon.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/evaluator.h"

namespace batten::core {

namespace {

constexpr int samples_in_span = 16;
constexpr int most_offset_halvings = 40;

// A curve slower than this part of what it reaches in its span has lost digits that its curvature needs.
constexpr double slow_share = 0.25;
// The result has so many spans at most, and some for each of the curve.
constexpr std::size_t most_spans = 20000;
constexpr std::size_t most_parts_of_span = 16;
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

// A part of the true offset by what is known of it at both ends and in the middle.
struct OffsetPart {
    Interval where;
    OffsetPoint start;
    OffsetPoint half;
    OffsetPoint end;

    double middle() const { return where.lower + 0.5 * where.length(); }
    bool is_divisible() const { return where.lower < middle() && middle() < where.upper; }

    // Hermite's cubic, t from 0 to 1.
    Point hermite(double t) const {
        const double third = where.length() / 3.0;
        const Vector a = third * start.derivative;
        const Vector c = end.point - start.point;
        const Vector b = c - third * end.derivative;
        return start.point + 3.0 * t * (1.0 - t) * (1.0 - t) * a + 3.0 * t * t * (1.0 - t) * b + t * t * t * c;
    }
};

// A span of the curve that is not empty.
struct CurveSpan {
    Interval part;
    double fastest = 0.0;  ///< the largest speed that its control points would give, if their weights were equal
};

double largest_coordinate(const Curve& curve) {
    double largest = 0.0;
    for (const Point& point : curve.control_points())
        largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    return largest;
}

double fastest_in(const Curve& curve, std::size_t span) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const auto points = curve.control_points();
    const KnotVector& knots = curve.knots();
    double fastest = 0.0;
    for (std::size_t i = span - p; i < span; ++i) {
        const Vector leg = points[(i + 1) % points.size()] - points[i % points.size()];
        fastest = std::max(fastest, static_cast<double>(p) * robust_length(leg) / (knots[i + p + 1] - knots[i + 1]));
    }
    return fastest;
}

std::vector<CurveSpan> measured_spans(const Curve& curve) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const KnotVector& knots = curve.knots();
    std::vector<CurveSpan> spans;
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s)
        if (knots[s] < knots[s + 1]) spans.push_back({{knots[s], knots[s + 1]}, fastest_in(curve, s)});
    return spans;
}

class OffsetBuilder {
  public:
    OffsetBuilder(const Curve& curve, double distance, double tolerance, const Progress& progress)
        : progress_(progress),
          curve_(curve),
          prepared_(curve),
          spans_(measured_spans(curve)),
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
        auto result = approximated(Checks::few);
        // An offset that turns between few places takes more.
        if (result && !(result->error <= tolerance_)) result = approximated(Checks::many);
        if (result && !(result->error <= tolerance_))
            return refuse_computed(
                {.code = CurveErrorCode::tolerance_not_reached, .value = tolerance_, .lower = result->error});
        return result;
    }

    std::optional<Approximation> circular_alone() { return check_corners() ? circular() : std::nullopt; }

  private:
    // In how many places between its ends Hermite's cubic is compared with the offset.
    enum class Checks { few, many };

    Result<Approximation> approximated(Checks checks) {
        if (auto check = collect_breaks(checks); !check) return refuse(check.error());
        return assembled().map([&](Curve result) {
            const double error = offset_error_bound(curve_, result, distance_);
            return Approximation{std::move(result), error};
        });
    }

    // Of the prepared curve unless it is slow.
    std::optional<double> curvature(const Jet& jet, double speed, double fastest, double u, Side side) const {
        if (!(speed >= slow_share * fastest)) return curvature_at(curve_, u, side);
        const double found = cross(jet[1] / speed, jet[2]) / speed / speed;
        return std::isfinite(found) ? std::optional(found) : std::nullopt;
    }

    Result<OffsetPoint> true_offset(const CurveSpan& span, double u, Side side = Side::right) const {
        const Jet jet = prepared_.derivatives_at(u, 2, side);
        const double speed = robust_length(jet[1]);
        const auto bend = curvature(jet, speed, span.fastest, u, side);
        if (!bend) return refuse({.code = CurveErrorCode::curve_stands_still, .value = u});
        const double stretch = 1.0 - distance_ * *bend;
        if (!(stretch > 0.0))
            return refuse({.code = CurveErrorCode::offset_too_far,
                           .value = u,
                           .lower = 1.0 / std::abs(*bend),
                           .upper = std::abs(distance_)});
        return OffsetPoint{jet.point + distance_ * turned_left(jet[1] / speed), stretch * jet[1]};
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
        if (curve_.is_periodic())
            if (auto check = check_corner(spans_.front().part.lower); !check) return check;
        for (std::size_t k = 1; k < spans_.size(); ++k)
            if (auto check = check_corner(spans_[k].part.lower); !check) return check;
        return {};
    }

    // The largest distance of `candidate` from the true offset over samples of its spans; none where there is no offset
    // or where it is more than `most`.
    std::optional<double> error_up_to(double most, const Curve& candidate) const {
        double largest = 0.0;
        const Progress progress = part_of(progress_, 0.0, 0.3);
        for (std::size_t s = 0; s < spans_.size(); ++s) {
            const CurveSpan& span = spans_[s];
            tell(progress, s, spans_.size());
            for (int k = 0; k <= samples_in_span; ++k) {
                const bool is_last = k == samples_in_span;
                const double u = is_last ? span.part.upper : span.part.lower + span.part.length() * k / samples_in_span;
                const Side side = is_last ? Side::left : Side::right;
                const auto expected = true_offset(span, u, side);
                if (!expected) return std::nullopt;
                largest = std::max(largest, core::distance(expected->point, point_at(candidate, u, side)));
                if (!(largest <= most)) return std::nullopt;
            }
        }
        return largest;
    }

    // The offset as it would be if the curve were all of the line or circle that it begins as: the control points are
    // moved, or scaled about the center. Taken where it is right.
    std::optional<Approximation> circular() const {
        const double u = curve_.domain().lower;
        const auto start = true_offset(spans_.front(), u);
        const auto curvature = curvature_at(curve_, u, Side::right);
        if (!start || !curvature) return std::nullopt;
        const Point origin = point_at(curve_, u);
        const Vector move = start->point - origin;
        CurveDefinition definition = curve_.definition();
        // C + d N + (-d k) (P - C) is C' + (1 - d k) (P - C') seen from the center, written without it for k near 0.
        for (Point& point : definition.points) point += move - distance_ * *curvature * (point - origin);
        const auto candidate = Curve::make(std::move(definition));
        if (!candidate) return std::nullopt;
        const auto error = error_up_to(std::min(noise_, tolerance_), *candidate);
        if (!error) return std::nullopt;
        return Approximation{*candidate, *error};
    }

    Result<void> collect_breaks(Checks checks) {
        breaks_.clear();
        const bool is_first = checks == Checks::few;
        const Progress progress = part_of(progress_, is_first ? 0.3 : 0.6, is_first ? 0.6 : 0.9);
        for (std::size_t s = 0; s < spans_.size(); ++s) {
            tell(progress, s, spans_.size());
            if (auto check = add_breaks_of(spans_[s], checks); !check) return check;
        }
        if (curve_.is_periodic()) breaks_.front().before = breaks_.back().before;
        for (Break& at : breaks_) {
            constexpr double least_jump = 1e-12;
            at.is_smooth = length(at.after - at.before) <= least_jump * length(at.after);
        }
        return {};
    }

    Result<void> add_breaks_of(const CurveSpan& span, Checks checks) {
        const auto [lower, upper] = span.part;
        const auto start = true_offset(span, lower);
        const auto end = true_offset(span, upper, Side::left);
        if (!start || !end) return refuse(!start ? start.error() : end.error());
        std::optional<OffsetPoint> half;
        for (int k = 1; k < samples_in_span; ++k) {
            const auto sample = true_offset(span, lower + span.part.length() * k / samples_in_span);
            if (!sample) return refuse(sample.error());
            if (2 * k == samples_in_span) half = *sample;
        }
        if (breaks_.empty()) breaks_.push_back({lower, start->point, start->derivative, start->derivative});
        breaks_.back().after = start->derivative;
        return add_part(span, {span.part, *start, *half, *end}, checks, 0);
    }

    // Adds the end of the part, and breaks inside it where Hermite's cubic is not near enough.
    Result<void> add_part(const CurveSpan& span, const OffsetPart& part, Checks checks, int depth) {
        OffsetPart left{{part.where.lower, part.middle()}, part.start, {}, part.half};
        OffsetPart right{{part.middle(), part.where.upper}, part.half, {}, part.end};
        for (OffsetPart* side : {&left, &right}) {
            const auto half = true_offset(span, side->middle());
            if (!half) return refuse(half.error());
            side->half = *half;
        }
        const auto near = is_near(span, part, left.half.point, right.half.point, checks);
        if (!near) return refuse(near.error());
        const bool is_divisible = depth < most_offset_halvings && left.is_divisible() && right.is_divisible();
        if (!*near && is_divisible)
            return add_part(span, left, checks, depth + 1).and_then([&] {
                return add_part(span, right, checks, depth + 1);
            });
        if (breaks_.size() > most_spans + most_parts_of_span * spans_.size())
            return refuse_computed(
                {.code = CurveErrorCode::tolerance_not_reached, .value = tolerance_, .lower = worst_});
        breaks_.push_back({part.where.upper, part.end.point, part.end.derivative, part.end.derivative});
        return {};
    }

    // Given the offset after a quarter and three quarters of the part.
    Result<bool> is_near(const CurveSpan& span, const OffsetPart& part, Point quarter, Point three_quarters,
                         Checks checks) {
        // Half of the tolerance is left to what lies between the samples and to rounding.
        const double allowed = std::max(0.5 * tolerance_, noise_);
        double error = core::distance(part.hermite(0.5), part.half.point);
        error = std::max(error, core::distance(part.hermite(0.25), quarter));
        error = std::max(error, core::distance(part.hermite(0.75), three_quarters));
        for (int k = 1; checks == Checks::many && error <= allowed && k < samples_in_span; ++k) {
            const double t = static_cast<double>(k) / samples_in_span;
            const auto expected = true_offset(span, part.where.lower + t * part.where.length());
            if (!expected) return refuse(expected.error());
            error = std::max(error, core::distance(part.hermite(t), expected->point));
        }
        if (error > allowed) worst_ = std::max(tolerance_, error);
        return error <= allowed;
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
    Evaluator prepared_;
    std::vector<CurveSpan> spans_;
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

std::optional<Curve> exact_offset(const Curve& curve, double distance) {
    const Progress silent;
    const auto found = OffsetBuilder(curve, distance, std::numeric_limits<double>::infinity(), silent).circular_alone();
    return found ? std::optional(found->curve) : std::nullopt;
}

}  // namespace batten::core
