#include "core/measure/conic_form.h"

#include <array>
#include <cmath>
#include <utility>

namespace batten::core {

namespace {

// u x + v y + w
struct LinearForm {
    double u = 0.0;
    double v = 0.0;
    double w = 0.0;
};

// Zero on the line through both tips, twice the signed area of the triangle that they make with (x, y).
LinearForm through(Vector a, Vector b) {
    return {a.y - b.y, b.x - a.x, cross(a, b)};
}

ImplicitConic product(const LinearForm& m, const LinearForm& n) {
    return {.a = m.u * n.u,
            .b = m.u * n.v + m.v * n.u,
            .c = m.v * n.v,
            .d = m.u * n.w + m.w * n.u,
            .e = m.v * n.w + m.w * n.v,
            .f = m.w * n.w};
}

// x - factor y, member by member.
ImplicitConic minus_multiple(const ImplicitConic& x, double factor, const ImplicitConic& y) {
    return {.a = x.a - factor * y.a,
            .b = x.b - factor * y.b,
            .c = x.c - factor * y.c,
            .d = x.d - factor * y.d,
            .e = x.e - factor * y.e,
            .f = x.f - factor * y.f};
}

ImplicitConic normalized(ImplicitConic conic) {
    const double largest = std::max({std::abs(conic.a), std::abs(conic.b), std::abs(conic.c)});
    const double first = conic.a != 0.0 ? conic.a : conic.b != 0.0 ? conic.b : conic.c;
    const double scale = std::copysign(largest, first);
    for (double* member : {&conic.a, &conic.b, &conic.c, &conic.d, &conic.e, &conic.f}) *member = *member / scale + 0.0;
    return conic;
}

// In barycentric coordinates l_i of its control points a conic is l1^2 = 4 w^2 l0 l2. Seen from its corner l0 and l2
// are linear without a constant.
ImplicitConic equation_of(const std::array<Point, 3>& points, double weight_squared) {
    const Vector from = points[0] - points[1];
    const Vector to = points[2] - points[1];
    const LinearForm l0 = through(Vector{}, to);
    const LinearForm l2 = through(from, Vector{});
    LinearForm l1 = through(to, from);
    ImplicitConic conic = minus_multiple(product(l1, l1), 4.0 * weight_squared, product(l0, l2));
    conic = normalized(conic);
    conic.origin = points[1];
    return conic;
}

ConicType type_of(double weight_squared) {
    if (std::abs(weight_squared - 1.0) <= 8.0 * std::numeric_limits<double>::epsilon()) return ConicType::parabola;
    return weight_squared < 1.0 ? ConicType::ellipse : ConicType::hyperbola;
}

}  // namespace

double ImplicitConic::value_at(Point point) const {
    const auto [x, y] = std::pair(point.x - origin.x, point.y - origin.y);
    return (a * x + b * y + d) * x + (c * y + e) * y + f;
}

ImplicitConic ImplicitConic::seen_from(Point new_origin) const {
    const Vector shift = new_origin - origin;
    ImplicitConic moved = *this;
    moved.origin = new_origin;
    moved.d = d + 2.0 * a * shift.x + b * shift.y;
    moved.e = e + b * shift.x + 2.0 * c * shift.y;
    moved.f = value_at(new_origin);
    return moved;
}

Result<ConicForm> conic_form(const BezierPiece& piece) {
    if (piece.points.size() != 3)
        return refuse({.code = CurveErrorCode::degree_unsuitable,
                       .value = static_cast<double>(piece.points.size()) - 1.0,
                       .lower = 2.0});
    const std::array points{project(piece.points[0]), project(piece.points[1]), project(piece.points[2])};
    const double area = cross(points[0] - points[1], points[2] - points[1]);
    const double size = std::max(distance(points[0], points[1]), distance(points[2], points[1]));
    if (!(std::abs(area) > 16.0 * std::numeric_limits<double>::epsilon() * size * size))
        return refuse({.code = CurveErrorCode::points_collinear});
    const double w1 = piece.points[1].z;
    const double weight_squared = (w1 / piece.points[0].z) * (w1 / piece.points[2].z);
    // Its square need not be a double.
    const double weight = w1 / (std::sqrt(piece.points[0].z) * std::sqrt(piece.points[2].z));
    const Point middle = points[0] + 0.5 * (points[2] - points[0]);
    const double ratio = weight / (1.0 + weight);
    return ConicForm{.interval = piece.interval,
                     .type = type_of(weight_squared),
                     .weight = weight,
                     .shoulder_ratio = ratio,
                     .shoulder = middle + ratio * (points[1] - middle),
                     .equation = equation_of(points, weight_squared)};
}

}  // namespace batten::core
