/// Makes conics as rational quadratic curves: circles, ellipses, parabolas, hyperbolas and their arcs.
#pragma once

#include "core/base/names.h"
#include "core/curve/curve.h"

namespace batten::core {

/// The polygon around a whole circle or ellipse.
enum class CirclePolygon {
    square,   ///< 9 points, four quarters; weights 1 and the root of 1/2
    triangle  ///< 7 points, three thirds; weights 1 and 1/2
};

template <>
struct Names<CirclePolygon> {
    static constexpr std::array table{Named{CirclePolygon::square, "9", "9, in a square"},
                                      Named{CirclePolygon::triangle, "7", "7, in a triangle"}};
};

/// Where an ellipse lies: its first semi-axis points in the direction `rotation` (degrees), its second one 90 degrees
/// further.
struct EllipseFrame {
    Point center{};
    double first_axis = 1.0;   ///< length of a semi-axis, > 0
    double second_axis = 1.0;  ///< likewise; equal to the first for a circle
    double rotation = 0.0;
};

/// The part of an ellipse from the angle `start` on, `sweep` far; in degrees, counter-clockwise when positive. The
/// angle is that of the circle of which the ellipse is the affine image: at `a` lies center + cos(a) first axis +
/// sin(a) second axis.
struct ArcAngles {
    double start = 0.0;
    double sweep = 360.0;  ///< from -360 to 360, not 0
};

/// The whole circle, counter-clockwise, as a clamped curve over [0, 1] whose ends meet at the angle 0. The four or
/// three pieces have spans of equal length. Errors: length_not_positive; point_not_finite.
[[nodiscard]] Result<Curve> circle(Point center, double radius, CirclePolygon polygon = CirclePolygon::square);

/// The whole ellipse likewise, from the end of its first semi-axis on.
[[nodiscard]] Result<Curve> ellipse(const EllipseFrame& frame, CirclePolygon polygon = CirclePolygon::square);

/// The arc of a circle over [0, 1] in the fewest equal pieces of at most 90 degrees, so 1 to 4 of them; the weights of
/// the inner points are the cosines of half a piece. A whole turn ends in its first point, bit-equal. Errors:
/// length_not_positive; angle_out_of_range; point_not_finite.
[[nodiscard]] Result<Curve> circular_arc(Point center, double radius, ArcAngles angles);

/// The arc of an ellipse likewise.
[[nodiscard]] Result<Curve> elliptic_arc(const EllipseFrame& frame, ArcAngles angles);

/// The arc of a parabola of this vertex and focal length (> 0), opening in the direction `axis` (degrees), as one
/// polynomial piece over [from, to]: seen along the axis, at t it is t to the right of it and t^2 / (4 focal_length)
/// beyond the vertex. Errors: length_not_positive; range_empty; point_not_finite.
[[nodiscard]] Result<Curve> parabola_arc(Point vertex, double focal_length, double axis, Interval range);

/// The arc of one branch of a hyperbola, center + cosh(t) first axis + sinh(t) second axis for t in the range, as one
/// rational piece over it with the middle weight cosh(length / 2); the parameter itself runs otherwise than t between
/// the ends. Errors: length_not_positive; range_empty; point_not_finite or weight_not_finite when the range is too far.
[[nodiscard]] Result<Curve> hyperbola_arc(const EllipseFrame& frame, Interval range);

/// The conic from `from` to `to` with the tangents through `corner`, whose weight is `weight` (> 0), the other weights
/// being 1; over [0, 1]. Errors: points_collinear; weight_not_finite; weight_not_positive; point_not_finite.
[[nodiscard]] Result<Curve> conic(Point from, Point corner, Point to, double weight);

}  // namespace batten::core
