#include "core/refine/detail/carried_point.h"

#include <cassert>
#include <utility>

#include "core/curve/control_box.h"

namespace batten::core {

namespace {

// Differences of numbers are exact when the larger is at most twice the smaller (Sterbenz).
double near_coordinate(double lower, double upper) {
    if (lower > 0.0 && upper <= 2.0 * lower) return lower;
    if (upper < 0.0 && lower >= 2.0 * upper) return upper;
    return 0.0;
}

CarriedPoint carried_point(Point point, double weight, Point origin, std::size_t source) {
    return {lift(seen_from(point, origin), weight), source};
}

PreciselyCarriedPoint precisely_carried_point(Point point, double weight, Point origin, std::size_t source) {
    return {lift_precisely(point, weight, origin), source};
}

template <class P>
Spline<P> carried_as(const Curve& curve, std::size_t periods, P (*carry)(Point, double, Point, std::size_t)) {
    const KnotVector& knots = curve.knots();
    const std::size_t n = curve.control_points().size();
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t margin = p + periods * n;
    Spline<P> spline{.p = p,
                     .knots = knots.is_periodic() ? unroll_period(knots.stored(), margin, margin)
                                                  : std::vector(knots.values().begin(), knots.values().end())};
    const Point origin = origin_near(curve);
    const bool is_rational = curve.is_rational();
    spline.points.reserve(spline.knots.size() - p);
    for (std::size_t i = 0; i + p + 1 < spline.knots.size(); ++i) {
        const std::size_t k = i % n;
        spline.points.push_back(carry(curve.control_points()[k], is_rational ? curve.weights()[k] : 1.0, origin, k));
    }
    return spline;
}

}  // namespace

Point origin_near(const Curve& curve) {
    const Box box = control_box(curve);
    return {near_coordinate(box.lower.x, box.upper.x), near_coordinate(box.lower.y, box.upper.y)};
}

CarriedSpline carried(const Curve& curve, std::size_t periods) {
    return carried_as(curve, periods, carried_point);
}

PreciselyCarriedSpline carried_precisely(const Curve& curve) {
    assert(!curve.is_periodic());
    return carried_as(curve, 0, precisely_carried_point);
}

namespace {

// What is left of several Bézier pieces may be one.
KnotKind kind_of(const CarriedForm& form) {
    const bool is_one_span = !form.is_periodic && form.knots.size() == 2 * (static_cast<std::size_t>(form.degree) + 1);
    return is_one_span && form.kind == KnotKind::piecewise_bezier ? KnotKind::bezier : form.kind;
}

}  // namespace

Result<Curve> settled(const Curve& from, CarriedForm form, std::span<const CarriedPoint> points) {
    const KnotKind kind = kind_of(form);
    const Point origin = origin_near(from);
    const bool is_rational = from.is_rational();
    CurveDefinition definition{.degree = form.degree,
                               .knots = std::move(form.knots),
                               .periodic = form.is_periodic,
                               .kind = kind,
                               .tears = from.is_torn() ? Tears::allow : form.tears};
    definition.points.reserve(points.size());
    definition.weights.reserve(points.size());
    for (const CarriedPoint& carried : points) {
        const bool is_kept = carried.source != CarriedPoint::is_new;
        if (!is_kept && !is_finite(carried.point)) return refuse({.code = CurveErrorCode::not_computable});
        if (!(carried.point.z > 0.0))
            return refuse({.code = CurveErrorCode::weight_not_positive,
                           .index = definition.points.size(),
                           .value = carried.point.z});
        definition.points.push_back(is_kept ? from.control_points()[carried.source]
                                            : origin + vector_to(project(carried.point)));
        if (!is_rational)
            definition.weights.push_back(from.weights().front());
        else
            definition.weights.push_back(is_kept ? from.weights()[carried.source] : carried.point.z);
    }
    return Curve::make(std::move(definition));
}

Result<Curve> settled(const Curve& from, CarriedSpline spline, KnotKind kind, Tears tears) {
    return settled(
        from, {.degree = static_cast<int>(spline.p), .knots = std::move(spline.knots), .kind = kind, .tears = tears},
        spline.points);
}

Result<Curve> settled(const Curve& from, PreciselyCarriedSpline spline, KnotKind kind) {
    CarriedSpline plain{.p = spline.p, .knots = std::move(spline.knots)};
    plain.points.reserve(spline.points.size());
    for (const PreciselyCarriedPoint& carried : spline.points)
        plain.points.push_back({rounded(carried.point), carried.source});
    return settled(from, std::move(plain), kind);
}

}  // namespace batten::core
