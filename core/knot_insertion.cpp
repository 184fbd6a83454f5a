#include "core/knot_insertion.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/bspline.h"
#include "core/edit_checks.h"

namespace batten::core {

namespace {

struct WeightedPoint {
    Point position{};
    double weight = 1.0;
};

// An open spline to insert into; for a periodic curve several of its periods side by side.
struct Strip {
    std::size_t p = 0;
    std::vector<double> knots;
    std::vector<WeightedPoint> points;
};

template <class Iterator>
Iterator advanced(Iterator iterator, std::size_t steps) {
    return iterator + static_cast<std::ptrdiff_t>(steps);
}

// A share of 0 or 1 is one of the two, which lifting and projecting would not keep to the last bit.
WeightedPoint blend_lifted(const WeightedPoint& a, const WeightedPoint& b, Ratio ratio) {
    if (ratio.upper_share == 0.0) return a;
    if (ratio.upper_share == 1.0) return b;
    const auto point = blend(lift(a.position, a.weight), lift(b.position, b.weight), ratio);
    return {project(point), point.z};
}

// A non-empty span of the strip's domain that `u` belongs to or ends.
std::size_t span_around(const Strip& strip, double u) {
    const auto first = advanced(strip.knots.begin(), strip.p + 1);
    const auto last = strip.knots.end() - static_cast<std::ptrdiff_t>(strip.p) - 1;
    const auto upper_knot = u < *last ? std::upper_bound(first, last, u) : std::lower_bound(first, last, *last);
    return static_cast<std::size_t>(upper_knot - strip.knots.begin()) - 1;
}

// Boehm's step: Q_i = (1 - alpha_i) P_{i-1} + alpha_i P_i for i = s-p+1..s, alpha_i = (u - u_i) / (u_{i+p} - u_i).
void insert_once(Strip& strip, double u) {
    const std::size_t s = span_around(strip, u);
    auto& points = strip.points;
    const WeightedPoint last_changed = points[s];
    points.insert(advanced(points.begin(), s), last_changed);
    for (std::size_t i = s; i > s - strip.p; --i)
        points[i] = blend_lifted(points[i - 1], points[i], ratio_between(strip.knots[i], strip.knots[i + strip.p], u));
    strip.knots.insert(std::upper_bound(strip.knots.begin(), strip.knots.end(), u), u);
}

void insert_often(Strip& strip, double u, int times) {
    for (int k = 0; k < times; ++k) insert_once(strip, u);
}

// The curve's spline with `periods` whole periods more on both sides; none for an open curve.
Strip strip_of(const Curve& curve, std::size_t periods) {
    const KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t n = curve.control_points().size();
    const std::size_t margin = p + periods * n;
    Strip strip{.p = p,
                .knots = knots.is_periodic() ? unroll_period(knots.stored(), margin, margin)
                                             : std::vector(knots.values().begin(), knots.values().end()),
                .points = {}};
    strip.points.reserve(strip.knots.size() - p);
    for (std::size_t i = 0; i + p + 1 < strip.knots.size(); ++i)
        strip.points.push_back({curve.control_points()[i % n], curve.weights()[i % n]});
    return strip;
}

// The curve like `like` whose points are those from `first_point` of the strip on, over these stored knots.
Result<Curve> curve_from(const Strip& strip, std::size_t first_point, std::vector<double> knots, const Curve& like) {
    CurveDefinition definition = like.definition();
    const std::size_t point_count = definition.points.size() + knots.size() - definition.knots.size();
    definition.knots = std::move(knots);
    definition.points.clear();
    definition.weights.clear();
    for (std::size_t i = first_point; i < first_point + point_count; ++i) {
        definition.points.push_back(strip.points[i].position);
        definition.weights.push_back(strip.points[i].weight);
    }
    return Curve::make(std::move(definition));
}

Result<Curve> insert_open(const Curve& curve, double u, int times) {
    Strip strip = strip_of(curve, 0);
    insert_often(strip, u, times);
    return curve_from(strip, 0, strip.knots, curve);
}

// Knot `u` and its repetitions in so many periods before and after, ascending; reckoned as unroll_period does, so that
// a repetition of u equals the repetition of the knot that u equals.
std::vector<double> repetitions(double u, Interval period, std::size_t periods) {
    std::vector<double> values(2 * periods + 1, u);
    for (std::size_t k = periods; k-- > 0;) values[k] = period.lower + (values[k + 1] - period.upper);
    for (std::size_t k = periods + 1; k < values.size(); ++k) values[k] = period.upper + (values[k - 1] - period.lower);
    return values;
}

// All repetitions of `u` come in, as in the endless spline. So many periods are laid out that everything on which the
// middle one depends lies inside the strip, also where a period has fewer points than the degree.
Result<Curve> insert_periodic(const Curve& curve, double u, int times) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t n = curve.control_points().size();
    const std::size_t periods = p / n + 1;
    Strip strip = strip_of(curve, periods);
    for (const double repetition : repetitions(u, curve.domain(), periods)) insert_often(strip, repetition, times);
    const auto added = static_cast<std::size_t>(times);
    const std::size_t first_knot = p + periods * n + periods * added;
    const auto period = std::span(strip.knots).subspan(first_knot, n + added + 1);
    return curve_from(strip, first_knot - p, {period.begin(), period.end()}, curve);
}

Result<void> check_insertion(const KnotVector& knots, double u, int times) {
    const Interval domain = knots.domain();
    if (const auto check = check_parameter_finite(u); !check) return check;
    if (!domain.contains(u))
        return refuse({.code = CurveErrorCode::parameter_outside_domain,
                       .value = u,
                       .lower = domain.lower,
                       .upper = domain.upper});
    const bool is_end = !knots.is_periodic() && (u == domain.lower || u == domain.upper);
    const int most = knots.degree() + (is_end ? 1 : 0);
    if (times > most - knots.multiplicity(u))
        return refuse({.code = CurveErrorCode::multiplicity_full, .value = u, .upper = static_cast<double>(most)});
    return {};
}

}  // namespace

Result<Curve> insert_knot(const Curve& curve, double u, int times) {
    assert(times >= 1);
    if (const auto check = check_insertion(curve.knots(), u, times); !check) return refuse(check.error());
    return curve.is_periodic() ? insert_periodic(curve, u, times) : insert_open(curve, u, times);
}

Result<Curve> insert_midpoint_knots(const Curve& curve) {
    const KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    Result<Curve> result = curve;
    for (std::size_t s = p; s + p + 1 < knots.size() && result; ++s) {
        const double middle = knots[s] + 0.5 * (knots[s + 1] - knots[s]);
        const bool has_inside = knots[s] < middle && middle < knots[s + 1];
        if (has_inside) result = insert_knot(*result, middle);
    }
    if (!result) return result;
    // Only when all are in are equal steps equal again.
    CurveDefinition definition = result->definition();
    definition.kind = knots.kind();
    return Curve::make(std::move(definition));
}

}  // namespace batten::core
