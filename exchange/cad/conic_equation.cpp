#include "exchange/cad/conic_equation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/double_double.h"
#include "core/make/conics.h"

namespace batten::exchange {

namespace {

using core::DoubleDouble;
using core::Point;
using core::Vector;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

using Arc = tl::expected<ConicArcOfEquation, std::string>;

Arc no_arc(const char* reason) {
    return tl::unexpected<std::string>(reason);
}

// The equation of h, the way from the start of the arc: h.Qh + gradient.h + rest = 0 with the symmetric matrix Q. The
// rest is 0 where the start lies on the conic.
struct SeenFromStart {
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    Vector gradient{};
    double rest = 0.0;

    Vector times_matrix(Vector h) const { return {xx * h.x + xy * h.y, xy * h.x + yy * h.y}; }
    double form(Vector a, Vector b) const { return dot(times_matrix(a), b); }
    double determinant() const {
        return (DoubleDouble(xx) * DoubleDouble(yy) - DoubleDouble(xy) * DoubleDouble(xy)).rounded();
    }
    /// What belongs to two points of a piece: its polar form.
    double polar(Vector a, Vector b) const { return form(a, b) + 0.5 * dot(gradient, a + b) + rest; }
    double rounding_of_polar(Vector a, Vector b) const;
};

double SeenFromStart::rounding_of_polar(Vector a, Vector b) const {
    constexpr double operations = 16.0;
    const Vector sum{std::abs(a.x) + std::abs(b.x), std::abs(a.y) + std::abs(b.y)};
    const double terms = std::abs(xx * a.x * b.x) + std::abs(xy) * (std::abs(a.x * b.y) + std::abs(a.y * b.x)) +
                         std::abs(yy * a.y * b.y) + std::abs(gradient.x) * sum.x + std::abs(gradient.y) * sum.y +
                         std::abs(rest);
    return operations * epsilon * terms;
}

// Of coefficients that are near 1, with Q positive where that can be.
SeenFromStart seen_from(const ConicEquation& equation, Point start) {
    const double largest = std::max({std::abs(equation.a), std::abs(equation.b), std::abs(equation.c)});
    const double sign = equation.a + equation.c < 0.0 ? -1.0 : 1.0;
    const auto scaled = [&](double value) { return sign * std::ldexp(value, -std::ilogb(largest)); };
    const DoubleDouble a = scaled(equation.a);
    const DoubleDouble b = scaled(equation.b);
    const DoubleDouble c = scaled(equation.c);
    const DoubleDouble d = scaled(equation.d);
    const DoubleDouble e = scaled(equation.e);
    const DoubleDouble x = start.x;
    const DoubleDouble y = start.y;
    const DoubleDouble by_x = a * x + b * y + d;
    const DoubleDouble by_y = c * y + e;
    return {.xx = a.rounded(),
            .xy = 0.5 * b.rounded(),
            .yy = c.rounded(),
            .gradient = {(by_x + a * x).rounded(), (by_y + c * y + b * x).rounded()},
            .rest = (by_x * x + by_y * y + DoubleDouble(scaled(equation.f))).rounded()};
}

// Where the digits of the coefficients do not tell, the name does.
bool is_parabola(const SeenFromStart& conic, ConicName name) {
    constexpr double rounded_coefficients = 1e-6;
    constexpr double rounded_doubles = 1e-14;
    const double size = conic.xx * conic.xx + 2.0 * conic.xy * conic.xy + conic.yy * conic.yy;
    const double nearness = name == ConicName::parabola ? rounded_coefficients : rounded_doubles;
    return std::abs(conic.determinant()) <= nearness * size;
}

// How large the left side of the equation is along the curve, at most, whose pieces are quadratic, with the weights 1,
// w and 1: the Bernstein coefficients of its numerator, of degree 4, bound it.
double largest_value(const SeenFromStart& conic, const core::CurveDefinition& curve) {
    double largest = 0.0;
    for (std::size_t i = 0; i + 2 < curve.points.size(); i += 2) {
        const auto point = [&](std::size_t k) { return curve.points[i + k] - curve.points.front(); };
        const auto polar = [&](std::size_t k, std::size_t l) { return conic.polar(point(k), point(l)); };
        const auto rounding = [&](std::size_t k, std::size_t l) { return conic.rounding_of_polar(point(k), point(l)); };
        const auto size = [&](std::size_t k, std::size_t l) { return std::abs(polar(k, l)) + rounding(k, l); };
        const double w = curve.weights.empty() ? 1.0 : curve.weights[i + 1];
        const double middle =
            (std::abs(polar(0, 2) + 2.0 * w * w * polar(1, 1)) + rounding(0, 2) + 2.0 * w * w * rounding(1, 1)) / 3.0;
        const double least_weight = std::min(1.0, 0.5 * (1.0 + w));
        largest = std::max(largest, std::max({size(0, 0), w * size(0, 1), middle, w * size(1, 2), size(2, 2)}) /
                                        (least_weight * least_weight));
    }
    return largest;
}

// `distance_of_value` is how far a point is from the conic, at most, for each unit of the value there.
Arc with_error(core::CurveDefinition curve, const SeenFromStart& conic, Point end, double distance_of_value) {
    const Point start = curve.points.front();
    curve.points.back() = end;
    double size = 0.0;
    for (const Point point : curve.points) size = std::max(size, core::distance(start, point));
    const double error = distance_of_value * largest_value(conic, curve);
    if (!(error < size)) return no_arc("its ends are not on the conic of its equation");
    return core::Curve::make(std::move(curve))
        .map([&](core::Curve made) {
            return ConicArcOfEquation{std::move(made), error};
        })
        .map_error(core::describe);
}

// With the half-axis u from the center to the start and v conjugate to it, points are center + cos t u + sin t v.
Arc ellipse_arc(const SeenFromStart& conic, Point start, Point end, Vector to_center) {
    constexpr double degrees = 180.0 / std::numbers::pi;
    constexpr double whole_turn = 360.0;
    const Vector u = -to_center;
    const Vector v = core::turned_left(conic.times_matrix(u)) / std::sqrt(conic.determinant());
    const Vector to_end = (end - start) - to_center;
    double turn = degrees * std::atan2(conic.form(v, to_end), conic.form(u, to_end));
    if (turn <= 0.0 || start == end) turn += whole_turn;
    auto unit = core::circular_arc({0.0, 0.0}, 1.0, {0.0, std::min(turn, whole_turn)});
    if (!unit) return tl::unexpected(core::describe(unit.error()));
    core::CurveDefinition curve = unit->definition();
    double reach = 0.0;
    for (Point& point : curve.points) {
        const Vector from_center = point.x * u + point.y * v;
        reach = std::max(reach, core::length(from_center));
        point = start + (to_center + from_center);
    }
    curve.points.front() = start;
    return with_error(std::move(curve), conic, end, reach / conic.form(u, u));
}

Arc one_piece(const SeenFromStart& conic, Point start, Point end, Vector to_corner, double weight,
              double distance_of_value) {
    if (start == end) return no_arc("its ends are one point");
    const auto curve = core::conic(start, start + to_corner, end, weight);
    if (!curve) return no_arc("its ends are not on the conic of its equation");
    return with_error(curve->definition(), conic, end, distance_of_value);
}

// Points are center + cosh t u + sinh t v.
Arc hyperbola_arc(const SeenFromStart& conic, Point start, Point end, Vector to_center) {
    const Vector u = -to_center;
    const Vector to_end = (end - start) - to_center;
    const double power = conic.form(u, u);
    const double cosh = conic.form(u, to_end) / power;
    if (!(cosh > 0.0)) return no_arc("its ends are not on one branch of a hyperbola");
    const double reach = std::max(core::length(u), core::length(to_end));
    return one_piece(conic, start, end, to_center + (u + to_end) / (1.0 + cosh), std::sqrt(0.5 * (1.0 + cosh)),
                     reach / std::abs(power));
}

// With Q = a a^T for the vector a, and n at a right angle to it, h = q a / |a|^2 + s n has s = -(q^2 + q l) / (gradient
// . n), where l = gradient . a / |a|^2: a quadratic function of q, whose polar form gives the corner.
Arc parabola_arc(const SeenFromStart& conic, Point start, Point end) {
    const Vector a{std::sqrt(std::max(conic.xx, 0.0)), std::copysign(std::sqrt(std::max(conic.yy, 0.0)), conic.xy)};
    const double square = core::dot(a, a);
    const Vector n = core::turned_left(a) / std::sqrt(square);
    const double along = core::dot(conic.gradient, n);
    if (along == 0.0) return no_arc("its equation is that of lines");
    const double half = 0.5 * core::dot(a, end - start);
    const double s = -half * core::dot(conic.gradient, a) / square / along;
    constexpr double for_rounded_coefficients = 2.0;
    return one_piece(conic, start, end, half * a / square + s * n, 1.0, for_rounded_coefficients / std::abs(along));
}

}  // namespace

tl::expected<ConicArcOfEquation, std::string> arc_of_equation(const ConicEquation& equation, ConicName name,
                                                              Point start, Point end) {
    if (equation.a == 0.0 && equation.b == 0.0 && equation.c == 0.0) return no_arc("its equation is that of a line");
    const SeenFromStart conic = seen_from(equation, start);
    if (is_parabola(conic, name)) return parabola_arc(conic, start, end);
    const double determinant = conic.determinant();
    const Vector g = conic.gradient;
    const Vector to_center =
        Vector{conic.xy * g.y - conic.yy * g.x, conic.xy * g.x - conic.xx * g.y} / (2.0 * determinant);
    if (conic.form(to_center, to_center) == 0.0) return no_arc("its equation is that of lines or of a point");
    return determinant > 0.0 ? ellipse_arc(conic, start, end, to_center) : hyperbola_arc(conic, start, end, to_center);
}

}  // namespace batten::exchange
