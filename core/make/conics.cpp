#include "core/make/conics.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/base/detail/angle.h"

namespace batten::core {

namespace {

// The plane of an ellipse: (1, 0) and (0, 1) are the ends of its semi-axes.
class EllipsePlane {
  public:
    explicit EllipsePlane(const EllipseFrame& frame) : center_(frame.center) {
        const Vector direction = unit_vector(frame.rotation);
        first_axis_ = frame.first_axis * direction;
        second_axis_ = frame.second_axis * turned_left(direction);
    }

    Point operator()(Vector v) const { return center_ + (v.x * first_axis_ + v.y * second_axis_); }

  private:
    Point center_;
    Vector first_axis_;
    Vector second_axis_;
};

Result<void> check_length(double length) {
    if (length > 0.0) return {};
    return refuse({.code = CurveErrorCode::length_not_positive, .value = length});
}

Result<void> check_axes(const EllipseFrame& frame) {
    return check_length(frame.first_axis).and_then([&] { return check_length(frame.second_axis); });
}

Result<void> check_sweep(double sweep) {
    if (std::abs(sweep) <= 360.0 && sweep != 0.0) return {};
    return refuse({.code = CurveErrorCode::angle_out_of_range, .value = sweep, .lower = -360.0, .upper = 360.0});
}

Result<void> check_range(Interval range) {
    if (range.lower < range.upper) return {};
    return refuse({.code = CurveErrorCode::range_empty, .lower = range.lower, .upper = range.upper});
}

// `pieces` quadratic pieces of the unit circle and the weight between their ends. The tangents at two ends c and d of a
// piece meet in (c + d) / (1 + cos piece), which is exact where they are.
CurveDefinition unit_arc(ArcAngles angles, std::size_t pieces) {
    const double step = angles.sweep / static_cast<double>(pieces);
    const double inner_weight = unit_vector(step / 2.0).x;
    const bool is_whole = std::abs(angles.sweep) == 360.0;
    CurveDefinition arc{.degree = 2, .knots = {0.0, 0.0, 0.0}, .kind = KnotKind::piecewise_bezier};
    arc.points.push_back(tip_of(unit_vector(angles.start)));
    arc.weights.push_back(1.0);
    for (std::size_t k = 1; k <= pieces; ++k) {
        const bool is_last = k == pieces;
        const double turned =
            is_last ? angles.sweep : angles.sweep * static_cast<double>(k) / static_cast<double>(pieces);
        const Vector before = vector_to(arc.points.back());
        const Vector end = is_last && is_whole ? vector_to(arc.points.front()) : unit_vector(angles.start + turned);
        arc.points.push_back(tip_of((before + end) / (1.0 + unit_vector(step).x)));
        arc.points.push_back(tip_of(end));
        arc.weights.insert(arc.weights.end(), {inner_weight, 1.0});
        arc.knots.insert(arc.knots.end(), 2, static_cast<double>(k) / static_cast<double>(pieces));
    }
    arc.knots.push_back(1.0);
    return arc;
}

Result<Curve> arc_of_pieces(const EllipseFrame& frame, ArcAngles angles, std::size_t pieces) {
    if (const auto check = check_axes(frame); !check) return refuse(check.error());
    CurveDefinition arc = unit_arc(angles, pieces);
    const EllipsePlane plane(frame);
    for (Point& point : arc.points) point = plane(vector_to(point));
    return Curve::make(std::move(arc));
}

// One quadratic piece over `range`, with a weight for its middle point.
Result<Curve> quadratic_piece(const std::array<Point, 3>& points, double weight, Interval range) {
    return Curve::make({.degree = 2,
                        .knots = {range.lower, range.lower, range.lower, range.upper, range.upper, range.upper},
                        .points = {points.begin(), points.end()},
                        .weights = {1.0, weight, 1.0},
                        .kind = KnotKind::bezier});
}

bool are_collinear(Point a, Point b, Point c) {
    const Vector ab = b - a;
    const Vector ac = c - a;
    // As far as rounding of the products can tell.
    return !(std::abs(cross(ab, ac)) >
             4.0 * std::numeric_limits<double>::epsilon() * (std::abs(ab.x * ac.y) + std::abs(ab.y * ac.x)));
}

}  // namespace

Result<Curve> circle(Point center, double radius, CirclePolygon polygon) {
    return ellipse({center, radius, radius, 0.0}, polygon);
}

Result<Curve> ellipse(const EllipseFrame& frame, CirclePolygon polygon) {
    return arc_of_pieces(frame, {0.0, 360.0}, polygon == CirclePolygon::square ? 4 : 3);
}

Result<Curve> circular_arc(Point center, double radius, ArcAngles angles) {
    return elliptic_arc({center, radius, radius, 0.0}, angles);
}

Result<Curve> elliptic_arc(const EllipseFrame& frame, ArcAngles angles) {
    if (const auto check = check_sweep(angles.sweep); !check) return refuse(check.error());
    return arc_of_pieces(frame, angles, static_cast<std::size_t>(std::ceil(std::abs(angles.sweep) / 90.0)));
}

Result<Curve> parabola_arc(Point vertex, double focal_length, double axis, Interval range) {
    const auto check = check_length(focal_length).and_then([&] { return check_range(range); });
    if (!check) return refuse(check.error());
    const Vector along = unit_vector(axis);
    const Vector across = -turned_left(along);
    const auto [t, end] = range;
    // The blossom of t and t^2.
    const auto place = [&](double right, double product) {
        return vertex + (right * across + product / (4.0 * focal_length) * along);
    };
    return quadratic_piece({place(t, t * t), place(t + 0.5 * (end - t), t * end), place(end, end * end)}, 1.0, range);
}

Result<Curve> hyperbola_arc(const EllipseFrame& frame, Interval range) {
    const auto check = check_axes(frame).and_then([&] { return check_range(range); });
    if (!check) return refuse(check.error());
    const EllipsePlane plane(frame);
    const double middle = range.lower + 0.5 * range.length();
    const double weight = std::cosh(0.5 * range.length());
    const auto branch = [](double t) { return Vector(std::cosh(t), std::sinh(t)); };
    return quadratic_piece({plane(branch(range.lower)), plane(branch(middle) / weight), plane(branch(range.upper))},
                           weight, range);
}

Result<Curve> conic(Point from, Point corner, Point to, double weight) {
    if (are_collinear(from, corner, to)) return refuse({.code = CurveErrorCode::points_collinear});
    return quadratic_piece({from, corner, to}, weight, {0.0, 1.0});
}

}  // namespace batten::core
