#include "core/curve/control_box.h"

namespace batten::core {

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
    return Curve::make(curve.knots(), std::move(points), {curve.weights().begin(), curve.weights().end()}).value();
}

}  // namespace batten::core
