/// Laws of the shape of a curve and of its invariance, on curves of every sort.
#include <cmath>

#include "core/evaluate/evaluate.h"
#include "core/measure/bounds.h"
#include "core/measure/nearest.h"
#include "tests/core/law_curves.h"

namespace batten::core::laws {

namespace {

// A curve point is rounded once to its place, and once more to where it lies from its first estimate: one unit each in
// x and y, and up to p steps of blending differences that are no larger than the polygon. Hardly ever more than 2.
constexpr double units_of_a_point = 4;

std::vector<Point> local_polygon(const Curve& curve, double u) {
    const std::size_t n = curve.control_points().size();
    const std::size_t s = curve.knots().span_at(u);
    std::vector<Point> points;
    for (std::size_t i = s - static_cast<std::size_t>(curve.degree()); i <= s; ++i)
        points.push_back(curve.control_points()[i % n]);
    return points;
}

// The curve with every homogeneous control point sent through `map`, which gives a point and the factor of its weight.
template <class Map>
Curve mapped(const Curve& curve, Map map) {
    CurveDefinition definition = curve.definition();
    definition.weights.assign(curve.weights().begin(), curve.weights().end());
    for (std::size_t i = 0; i < definition.points.size(); ++i) {
        const auto [point, factor] = map(definition.points[i]);
        definition.points[i] = point;
        definition.weights[i] *= factor;
    }
    const auto result = Curve::make(std::move(definition));
    if (!result) RC_FAIL(describe(result.error()));
    return *result;
}

int sign_changes(const std::vector<double>& values, bool is_cyclic) {
    if (values.empty()) return 0;
    int changes = 0;
    for (std::size_t i = 1; i < values.size(); ++i) changes += (values[i] > 0) != (values[i - 1] > 0) ? 1 : 0;
    if (is_cyclic) changes += (values.front() > 0) != (values.back() > 0) ? 1 : 0;
    return changes;
}

// How often `points`, one after the other, change from one side of the line through `origin` to the other. What is too
// near to the line to be told from it is left out, which can only lower the number.
int crossings(const std::vector<Point>& points, Point origin, Vector normal, double tolerance, bool is_cyclic) {
    std::vector<double> sides;
    for (const Point& point : points) {
        const double side = dot(point - origin, normal);
        if (std::abs(side) > tolerance) sides.push_back(side);
    }
    return sign_changes(sides, is_cyclic);
}

}  // namespace

TEST(ShapeLaws, convex_hull) {
    check_everywhere("a curve point lies in the hull of its p+1 control points", [](Setting setting) {
        const Curve curve = draw_curve(setting);
        const double u = draw_parameter(curve);
        const Point point = point_at(curve, u);
        const auto polygon = local_polygon(curve, u);
        const double tolerance = units_of_a_point * unit_of(curve);
        for (int k = 0; k < 16; ++k) {
            const Vector direction(std::cos(k * 0.39269908169872414), std::sin(k * 0.39269908169872414));
            double farthest = -std::numeric_limits<double>::infinity();
            for (const Point& corner : polygon) farthest = std::max(farthest, dot(corner - point, direction));
            RC_ASSERT(farthest >= -tolerance);
        }
    });
}

// The curve is only sampled, so what is found may be less than there is, never more.
TEST(ShapeLaws, variation_diminishing) {
    check_everywhere("no line meets the curve more often than the polygon", [](Setting setting) {
        const Curve curve = draw_curve(setting);
        const auto corners = std::vector<Point>(curve.control_points().begin(), curve.control_points().end());
        const double angle = draw_number(0.0, 3.1);
        const Vector normal(std::cos(angle), std::sin(angle));
        const Point origin = middle(point_at(curve, draw_parameter(curve)), point_at(curve, draw_parameter(curve)));
        const double tolerance = units_of_a_point * unit_of(curve);
        for (const Point& corner : corners) RC_PRE(std::abs(dot(corner - origin, normal)) > tolerance);
        std::vector<Point> samples;
        const KnotVector& knots = curve.knots();
        for (std::size_t s = 0; s + 1 < knots.size(); ++s)
            if (knots[s] < knots[s + 1] && curve.domain().contains(knots[s]) && curve.domain().contains(knots[s + 1]))
                for (int k = 0; k < 24; ++k)
                    samples.push_back(point_at(curve, knots[s] + (knots[s + 1] - knots[s]) * k / 24.0));
        samples.push_back(point_at(curve, curve.domain().upper));
        const bool is_cyclic = curve.is_periodic();
        RC_ASSERT(crossings(samples, origin, normal, tolerance, is_cyclic) <=
                  crossings(corners, origin, normal, tolerance, is_cyclic));
    });
}

// Both sides round the mapped control points and the point once; the map multiplies errors by at most its size.
TEST(ShapeLaws, affine_invariance) {
    check_everywhere("mapping the control points maps the curve", [](Setting setting) {
        const Curve curve = draw_curve(setting);
        const double a = draw_number(-2, 2);
        const double b = draw_number(-2, 2);
        const double c = draw_number(-2, 2);
        const double d = draw_number(-2, 2);
        const Vector shift(draw_number(-10, 10), draw_number(-10, 10));
        const auto map = [&](Point p) { return Point(a * p.x + b * p.y, c * p.x + d * p.y) + shift; };
        const Curve image = mapped(curve, [&](Point p) { return std::pair(map(p), 1.0); });
        const double u = draw_parameter(curve);
        const double growth = std::abs(a) + std::abs(b) + std::abs(c) + std::abs(d);
        const double tolerance = units_of_a_point * (1 + growth) * (unit_of(curve) + std::ldexp(10.0, -53));
        RC_ASSERT(distance(map(point_at(curve, u)), point_at(image, u)) <= tolerance);
    });
}

// (x, y) -> (x, y) / (1 + e x + f y), whose denominators stay from 1/2 to 3/2; weights are multiplied by them.
TEST(ShapeLaws, projective_invariance) {
    check_everywhere("a projective map of a curve maps its homogeneous control points", [](Setting setting) {
        const Curve curve = draw_curve(setting);
        const double size = std::ldexp(unit_of(curve), 53);
        RC_PRE(size > 0.0);
        const double e = draw_number(-0.25, 0.25) / size;
        const double f = draw_number(-0.25, 0.25) / size;
        const auto denominator = [&](Point p) { return 1 + e * p.x + f * p.y; };
        const Curve image =
            mapped(curve, [&](Point p) { return std::pair(tip_of(vector_to(p) / denominator(p)), denominator(p)); });
        const double u = draw_parameter(curve);
        const Point point = point_at(curve, u);
        // The points grow at most twice, and errors in them and in the denominators at most four times.
        RC_ASSERT(distance(tip_of(vector_to(point) / denominator(point)), point_at(image, u)) <=
                  8 * units_of_a_point * unit_of(curve));
    });
}

// Where the curve meets itself, or nearly, another parameter may come out; the point is the same up to the resolution
// that nearest_point promises, 1e-14 of the size of curve and query.
TEST(ShapeLaws, a_curve_point_is_its_own_nearest) {
    check_everywhere("nearest(at(u)) is at(u)", [](Setting setting) {
        const Curve curve = draw_curve(setting);
        const double u = draw_parameter(curve);
        const Point point = point_at(curve, u);
        const CurveSample found = nearest_point(curve, point);
        double size = 0.0;
        for (const Point& corner : curve.control_points()) size = std::max(size, distance(corner, point));
        const double tolerance = 2e-14 * size + units_of_a_point * unit_of(curve);
        RC_ASSERT(distance(found.point, point) <= tolerance);
        RC_ASSERT(curve.domain().contains(found.u));
        RC_ASSERT(distance(point_at(curve, found.u, Side::left), found.point) <= tolerance);
    });
}

}  // namespace batten::core::laws
