#include "core/curve/curve.h"

#include <cmath>
#include <utility>

namespace batten::core {

namespace {

using Check = Result<void>;

// Said here, where the number of points is known, because a vector that is short by a convention of counting (n + p - 1
// knots) may be a sound one for fewer points.
Check check_counts(int degree, bool is_periodic, std::size_t point_count, std::size_t knot_count) {
    const auto p = static_cast<std::size_t>(degree);
    const std::size_t least_points = is_periodic ? 2 : p + 1;
    if (point_count < least_points)
        return refuse({.code = CurveErrorCode::too_few_points,
                       .value = static_cast<double>(point_count),
                       .lower = static_cast<double>(least_points)});
    const std::size_t knots_expected = point_count + (is_periodic ? 1 : p + 1);
    if (knot_count != knots_expected)
        return refuse({.code = CurveErrorCode::knot_count_mismatch,
                       .value = static_cast<double>(knot_count),
                       .lower = static_cast<double>(knots_expected)});
    return {};
}

Check check_points(std::span<const Point> points) {
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!is_finite(points[i])) return refuse({.code = CurveErrorCode::point_not_finite, .index = i});
    return {};
}

Check check_weight_count(std::size_t weight_count, std::size_t point_count) {
    if (weight_count != point_count)
        return refuse({.code = CurveErrorCode::weight_count_mismatch,
                       .value = static_cast<double>(weight_count),
                       .lower = static_cast<double>(point_count)});
    return {};
}

Check check_weights_finite(std::span<const double> weights) {
    for (std::size_t i = 0; i < weights.size(); ++i)
        if (!std::isfinite(weights[i])) return refuse({.code = CurveErrorCode::weight_not_finite, .index = i});
    return {};
}

Check check_weights_positive(std::span<const double> weights) {
    for (std::size_t i = 0; i < weights.size(); ++i)
        if (weights[i] <= 0.0)
            return refuse({.code = CurveErrorCode::weight_not_positive, .index = i, .value = weights[i]});
    return {};
}

}  // namespace

Curve::Curve(KnotVector knots, SharedArray<Point> points, SharedArray<double> weights, bool is_rational)
    : knots_(std::move(knots)), points_(std::move(points)), weights_(std::move(weights)), is_rational_(is_rational) {}

Result<Curve> Curve::make(CurveDefinition definition) {
    const Check check = check_degree(definition.degree).and_then([&] {
        return check_counts(definition.degree, definition.periodic, definition.points.size(), definition.knots.size());
    });
    if (!check) return refuse(check.error());
    auto knots =
        definition.periodic
            ? KnotVector::make_periodic(definition.degree, std::move(definition.knots), definition.kind)
            : KnotVector::make(definition.degree, std::move(definition.knots), definition.kind, definition.tears);
    if (!knots) return refuse(knots.error());
    return make(std::move(*knots), std::move(definition.points), std::move(definition.weights));
}

Result<Curve> Curve::make(KnotVector knots, std::vector<Point> points, std::vector<double> weights) {
    if (weights.empty()) weights.assign(points.size(), 1.0);
    const Check check = check_counts(knots.degree(), knots.is_periodic(), points.size(), knots.stored().size())
                            .and_then([&] { return check_points(points); })
                            .and_then([&] { return check_weight_count(weights.size(), points.size()); })
                            .and_then([&] { return check_weights_finite(weights); })
                            .and_then([&] { return check_weights_positive(weights); });
    if (!check) return refuse(check.error());
    const bool is_rational = std::ranges::adjacent_find(weights, std::not_equal_to<>()) != weights.end();
    return Curve(std::move(knots), SharedArray(std::move(points)), SharedArray(std::move(weights)), is_rational);
}

bool Curve::is_torn() const {
    const Interval domain = knots_.domain();
    const auto values = knots_.values();
    const auto p = static_cast<std::size_t>(degree());
    for (std::size_t i = 0; i + p < values.size(); ++i)
        if (values[i] == values[i + p] && domain.lower < values[i] && values[i] < domain.upper) return true;
    return false;
}

CurveDefinition Curve::definition() const {
    const auto stored = knots_.stored();
    return {.degree = degree(),
            .knots = {stored.begin(), stored.end()},
            .points = {control_points().begin(), control_points().end()},
            .weights = {weights().begin(), weights().end()},
            .periodic = is_periodic(),
            .kind = knots_.kind(),
            .tears = is_torn() ? Tears::allow : Tears::refuse};
}

}  // namespace batten::core
