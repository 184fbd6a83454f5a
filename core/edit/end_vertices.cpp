#include "core/edit/end_vertices.h"

#include <utility>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/uniform_cubic.h"

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

}  // namespace

Result<Curve> add_end_vertex(const Curve& curve, CurveEnd end, EndVertex vertex) {
    if (!is_uniform_cubic(curve) || curve.is_periodic())
        return refuse({.code = CurveErrorCode::curve_not_uniform_cubic});
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

}  // namespace batten::core
