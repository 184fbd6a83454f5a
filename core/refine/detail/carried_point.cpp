#include "core/refine/detail/carried_point.h"

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

double carried_weight(const Curve& curve, bool is_rational, std::size_t i) {
    return is_rational ? curve.weights()[i] : 1.0;
}

}  // namespace

Point origin_near(const Curve& curve) {
    const Box box = control_box(curve);
    return {near_coordinate(box.lower.x, box.upper.x), near_coordinate(box.lower.y, box.upper.y)};
}

CarriedSpline carried(const Curve& curve, std::size_t periods) {
    const KnotVector& knots = curve.knots();
    const std::size_t n = curve.control_points().size();
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t margin = p + periods * n;
    CarriedSpline spline{.p = p,
                         .knots = knots.is_periodic() ? unroll_period(knots.stored(), margin, margin)
                                                      : std::vector(knots.values().begin(), knots.values().end())};
    const Point origin = origin_near(curve);
    const bool is_rational = curve.is_rational();
    spline.points.reserve(spline.knots.size() - p);
    for (std::size_t i = 0; i + p + 1 < spline.knots.size(); ++i) {
        const std::size_t k = i % n;
        const double weight = carried_weight(curve, is_rational, k);
        spline.points.push_back({lift(seen_from(curve.control_points()[k], origin), weight), k});
    }
    return spline;
}

Result<Curve> settled(const Curve& from, CarriedForm form, std::span<const CarriedPoint> points) {
    const Point origin = origin_near(from);
    const bool is_rational = from.is_rational();
    CurveDefinition definition{.degree = form.degree,
                               .knots = std::move(form.knots),
                               .periodic = form.is_periodic,
                               .kind = form.kind,
                               .tears = from.is_torn() ? Tears::allow : form.tears};
    definition.points.reserve(points.size());
    definition.weights.reserve(points.size());
    for (const CarriedPoint& carried : points) {
        if (!(carried.point.z > 0.0))
            return refuse({.code = CurveErrorCode::weight_not_positive,
                           .index = definition.points.size(),
                           .value = carried.point.z});
        const bool is_kept = carried.source != CarriedPoint::is_new;
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

}  // namespace batten::core
