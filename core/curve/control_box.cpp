#include "core/curve/control_box.h"

#include <algorithm>
#include <cmath>

#include "core/curve/detail/bspline.h"

namespace batten::core {

namespace {

// Divided by a power of two, so that the largest is between 1 and 2 and nothing else changes.
std::vector<double> weights_of_order_one(const Curve& curve) {
    std::vector<double> weights(curve.weights().begin(), curve.weights().end());
    const int order = std::ilogb(*std::max_element(weights.begin(), weights.end()));
    for (double& weight : weights) weight = divided_by_power(weight, order);
    return weights;
}

}  // namespace

Box control_box(const Curve& curve) {
    Box box;
    for (const Point& point : curve.control_points()) box.include(point);
    return box;
}

Point middle_of(const Curve& curve) {
    const Box box = control_box(curve);
    return middle(box.lower, box.upper);
}

Curve seen_from(const Curve& curve, Point origin) {
    std::vector<Point> points(curve.control_points().begin(), curve.control_points().end());
    for (Point& point : points) point = seen_from(point, origin);
    return Curve::make(curve.knots(), std::move(points), weights_of_order_one(curve)).value();
}

}  // namespace batten::core
