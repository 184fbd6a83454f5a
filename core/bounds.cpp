#include "core/bounds.h"

#include <algorithm>

namespace batten::core {

namespace {

bool is_left_of(Point a, Point b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

bool turns_left(Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0.0;
}

// Extends the chain that begins at `base` of `hull` by `point`, dropping what would not turn left.
void extend_chain(std::vector<Point>& hull, std::size_t base, Point point) {
    while (hull.size() >= base + 2 && !turns_left(hull[hull.size() - 2], hull.back(), point)) hull.pop_back();
    hull.push_back(point);
}

}  // namespace

Box control_box(const Curve& curve) {
    Box box;
    for (const Point& point : curve.control_points()) box.include(point);
    return box;
}

std::vector<Point> convex_hull(std::span<const Point> points) {
    std::vector<Point> sorted(points.begin(), points.end());
    if (sorted.size() < 3) return sorted;
    std::sort(sorted.begin(), sorted.end(), is_left_of);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() < 3) return sorted;
    std::vector<Point> hull;
    for (const Point& point : sorted) extend_chain(hull, 0, point);
    const std::size_t lower_end = hull.size() - 1;
    for (auto point = sorted.rbegin() + 1; point != sorted.rend(); ++point) extend_chain(hull, lower_end, *point);
    hull.pop_back();
    return hull;
}

}  // namespace batten::core
