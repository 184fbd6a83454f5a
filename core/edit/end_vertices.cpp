#include "core/edit/end_vertices.h"

#include <array>
#include <cassert>
#include <utility>

namespace batten::core {

namespace {

// One knot step beyond the first knot, and `point` before the first point.
void prepend(CurveDefinition& curve, Point point, double weight) {
    curve.knots.insert(curve.knots.begin(), curve.knots[0] - (curve.knots[1] - curve.knots[0]));
    curve.points.insert(curve.points.begin(), point);
    curve.weights.insert(curve.weights.begin(), weight);
}

void append(CurveDefinition& curve, Point point, double weight) {
    const std::size_t last = curve.knots.size() - 1;
    curve.knots.push_back(curve.knots[last] + (curve.knots[last] - curve.knots[last - 1]));
    curve.points.push_back(point);
    curve.weights.push_back(weight);
}

Result<void> check_open_uniform_cubic(const Curve& curve) {
    if (is_uniform_cubic(curve) && !curve.is_periodic()) return {};
    return refuse({.code = CurveErrorCode::curve_not_uniform_cubic});
}

Result<void> check_polynomial(const Curve& curve) {
    if (!curve.is_rational()) return {};
    return refuse({.code = CurveErrorCode::curve_rational});
}

// The outer vertices from the end inward, the added ones first.
std::array<Point, 3> outer_vertices(Point outer, Point inner, Point third, std::optional<EndVertex> vertex) {
    if (!vertex) return {outer, inner, third};
    switch (*vertex) {
        case EndVertex::doubled:
            return {outer, outer, inner};
        case EndVertex::tripled:
            return {outer, outer, outer};
        case EndVertex::phantom:
            break;
    }
    return {outer + (outer - inner), outer, inner};
}

}  // namespace

Result<Curve> add_end_vertex(const Curve& curve, CurveEnd end, EndVertex vertex) {
    if (const auto check = check_open_uniform_cubic(curve); !check) return refuse(check.error());
    CurveDefinition definition = curve.definition();
    const std::size_t last = definition.points.size() - 1;
    const bool is_start = end == CurveEnd::start;
    const std::size_t outer = is_start ? 0 : last;
    const std::size_t inner = is_start ? 1 : last - 1;
    const Point point = definition.points[outer];
    const Point reflected = point + (point - definition.points[inner]);
    const double outer_weight = definition.weights[outer];
    const double inner_weight = definition.weights[inner];
    const auto add = [&](Point added, double weight) {
        is_start ? prepend(definition, added, weight) : append(definition, added, weight);
    };
    if (vertex == EndVertex::phantom) {
        add(reflected, inner_weight);
    } else {
        add(point, outer_weight);
        if (vertex == EndVertex::tripled) add(point, outer_weight);
    }
    return Curve::make(std::move(definition));
}

Anticentroid end_joint(const Curve& curve, CurveEnd end, std::optional<EndVertex> vertex) {
    assert(curve.degree() == 3 && !curve.is_periodic() && !curve.is_rational());
    const auto P = curve.control_points();
    const std::size_t last = P.size() - 1;
    const bool is_start = end == CurveEnd::start;
    const auto [outer, middle, inner] =
        is_start ? outer_vertices(P[0], P[1], P[2], vertex) : outer_vertices(P[last], P[last - 1], P[last - 2], vertex);
    Anticentroid joint = is_start ? anticentroid_of(outer, middle, inner) : anticentroid_of(inner, middle, outer);
    joint.index = is_start ? 1 : last - 1;
    joint.u = is_start ? curve.domain().lower : curve.domain().upper;
    return joint;
}

Result<Curve> share_end_vertices(const Curve& curve, CurveEnd end, const Curve& other) {
    for (const Curve* each : {&curve, &other}) {
        const auto check = check_open_uniform_cubic(*each).and_then([&] { return check_polynomial(*each); });
        if (!check) return refuse(check.error());
    }
    CurveDefinition definition = curve.definition();
    const auto of_other = other.control_points();
    if (end == CurveEnd::start)
        std::copy(of_other.end() - 3, of_other.end(), definition.points.begin());
    else
        std::copy(of_other.begin(), of_other.begin() + 3, definition.points.end() - 3);
    return Curve::make(std::move(definition));
}

}  // namespace batten::core
