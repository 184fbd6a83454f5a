/// How a curve bends: its curvature, the circle that fits best, and where the curvature is zero or greatest or least.
#pragma once

#include <optional>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// The signed curvature (positive where the curve turns left) and how fast it changes.
struct Bending {
    double curvature = 0.0;      ///< as curvature_at gives it
    double by_parameter = 0.0;   ///< d curvature / du
    double by_arc_length = 0.0;  ///< d curvature / ds, which does not depend on the parametrization
};

/// The bending at `u`, seen from `side` at a knot: with v = |C'|,
///     k' = (det(C', C''') - 3 det(C', C'') (C' . C'') / v^2) / v^3
/// None at zero speed, as curvature_at. Cost O(p^2).
std::optional<Bending> bending_at(const Curve& curve, double u, Side side = Side::right);

/// The circle that a curve follows best at a point: the same tangent and the same curvature.
struct OsculatingCircle {
    Point center{};
    double radius = 0.0;  ///< 1 / |curvature| > 0
};

/// The osculating circle at `u`, seen from `side` at a knot, its center on the side to which the curve turns. None
/// where there is no curvature, where it is zero, and where the circle is too large for doubles. Cost O(p^2).
std::optional<OsculatingCircle> osculating_circle(const Curve& curve, double u, Side side = Side::right);

/// Where the curve passes from bending to one side to bending to the other.
struct Inflection {
    Interval where;        ///< one parameter, or the whole of a straight piece between the two bends
    double u = 0.0;        ///< the middle of `where`
    Point point{};         ///< C(u)
    bool is_jump = false;  ///< the curvature jumps from one sign to the other, which it does at a knot only
};

/// All inflections in order of u. They are the changes of sign of det(A, A', A'') for the homogeneous curve A, found
/// globally; zeros without a change of sign are none. A knot where the curvature jumps from one sign to the other is an
/// inflection if the tangent is continuous there, a corner or cusp is not. The seam of a curve that closes with a
/// continuous tangent counts like a knot; a straight piece across it is given unwrapped.
std::vector<Inflection> inflections(const Curve& curve);

/// Those whose parameter is in `range`, inside the domain and not empty; what passes an end of it is cut there. Cost:
/// that of the spans that have something in common with it and of one beside each end.
std::vector<Inflection> inflections_within(const Curve& curve, Interval range);

/// A local extremum of the signed curvature.
struct CurvatureExtremum {
    Interval where;          ///< one parameter, or the whole of an arc of constant curvature
    double u = 0.0;          ///< the middle of `where`
    Point point{};           ///< C(u)
    double curvature = 0.0;  ///< there; where it jumps, on the side where it is more extreme
    bool is_maximum = false;
};

/// All extrema of the signed curvature strictly inside the curve, in order of u: the changes of sign of its derivative,
/// a polynomial of degree up to 8p, found globally. Arcs of constant curvature count once, and only if they lie higher
/// or lower than what is on both sides; a circle has none. Corners, tears and cusps are no extrema. The seam of a
/// curve that closes with a continuous tangent counts like a knot.
std::vector<CurvatureExtremum> curvature_extrema(const Curve& curve);

/// Those whose parameter is in `range`, as inflections_within.
std::vector<CurvatureExtremum> curvature_extrema_within(const Curve& curve, Interval range);

}  // namespace batten::core
