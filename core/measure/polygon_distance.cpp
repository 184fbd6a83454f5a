#include "core/measure/polygon_distance.h"

#include <limits>
#include <utility>
#include <vector>

#include "core/curve/detail/bspline.h"
#include "core/curve/knot_analysis.h"
#include "core/measure/deviation.h"

namespace batten::core {

namespace {

// Where the polygon is at one parameter.
struct Corner {
    double u = 0.0;
    HomogeneousPoint point{};
};

// The corners of the unrolled curve, ascending.
std::vector<Corner> corners_of(const Curve& curve) {
    std::vector<Corner> corners;
    const std::size_t count = curve.knots().size() - static_cast<std::size_t>(curve.degree()) - 1;
    corners.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        corners.push_back({greville_abscissa(curve.knots(), i), curve.homogeneous_point(i)});
    return corners;
}

Corner on_leg(const Corner& from, const Corner& to, double u) {
    if (u <= from.u) return {u, from.point};
    if (u >= to.u) return {u, to.point};
    return {u, blend_between(from.point, to.point, from.u, to.u, u)};
}

// What is over the domain; where it ends inside a leg there is a corner, too.
std::vector<Corner> over_domain(const std::vector<Corner>& corners, Interval domain) {
    std::size_t first = 1;
    while (first + 1 < corners.size() && corners[first].u <= domain.lower) ++first;
    std::size_t last = first;
    while (last + 1 < corners.size() && corners[last].u < domain.upper) ++last;
    std::vector<Corner> over{on_leg(corners[first - 1], corners[first], domain.lower)};
    for (std::size_t i = first; i < last; ++i) over.push_back(corners[i]);
    over.push_back(on_leg(corners[last - 1], corners[last], domain.upper));
    return over;
}

// The polygon over the domain as a curve of degree 1.
Result<Curve> polygon_curve(const Curve& curve) {
    CurveDefinition polygon{.degree = 1, .knots = {curve.domain().lower}, .tears = Tears::allow};
    for (const Corner& corner : over_domain(corners_of(curve), curve.domain())) {
        polygon.knots.push_back(corner.u);
        polygon.points.push_back(project(corner.point));
        polygon.weights.push_back(corner.point.z);
    }
    polygon.knots.push_back(curve.domain().upper);
    return Curve::make(std::move(polygon));
}

}  // namespace

double polygon_distance(const Curve& curve) {
    if (curve.degree() == 1) return 0.0;
    const Result<Curve> polygon = polygon_curve(curve);
    return polygon ? largest_deviation(curve, *polygon) : std::numeric_limits<double>::infinity();
}

}  // namespace batten::core
