/// What two curves are to each other where they meet or shall meet, up to the change of curvature.
#pragma once

#include <optional>

#include "core/base/names.h"
#include "core/curve/curve.h"
#include "core/curve/curve_end.h"

namespace batten::core {

/// What agrees where two curves meet, whatever their parametrizations.
enum class GeometricContinuity {
    g0,  ///< the points
    g1,  ///< and the directions
    g2,  ///< and the curvatures
    g3   ///< and the changes of curvature by arc length
};

template <>
struct Names<GeometricContinuity> {
    static constexpr std::array table{
        Named{GeometricContinuity::g0, "G0", "G0"}, Named{GeometricContinuity::g1, "G1", "G1"},
        Named{GeometricContinuity::g2, "G2", "G2"}, Named{GeometricContinuity::g3, "G3", "G3"}};
};

/// How many of direction, curvature and its change agree, 0 to 3.
constexpr int order_of(GeometricContinuity continuity) {
    return static_cast<int>(continuity);
}

/// How a curve passes a place, whatever its parametrization.
struct Passing {
    Point point{};
    std::optional<Vector> direction{};  ///< a unit vector; none where the piece is a single point
    std::optional<double> curvature{};  ///< none at zero speed
    std::optional<double> change{};     ///< of curvature by arc length, d curvature / ds; none at zero speed
    double curvature_noise = 0.0;       ///< what rounding of the coordinates makes of them
    double change_noise = 0.0;
};

/// The curve at `u`, seen from `side` at a knot. Cost O(p^3).
Passing passing_at(const Curve& curve, double u, Side side);

/// The curve as it leaves its start, or as it arrives at its end.
Passing passing_at(const Curve& curve, CurveEnd end);

/// The curve as it goes on beyond its end: at its start run through the other way.
Passing passing_beyond(const Curve& curve, CurveEnd end);

/// The same run through the other way: direction and curvature change their signs, d curvature / ds does not.
Passing run_back(Passing passing);

/// What is between the two sides of a place, run through from the one into the other.
struct Meeting {
    double gap = 0.0;                       ///< distance of the points
    std::optional<double> angle{};          ///< by which the tangent turns, in (-pi, pi]; none without directions
    std::optional<double> before{};         ///< curvature of the side that comes first
    std::optional<double> after{};          ///< curvature of the other
    std::optional<double> change_before{};  ///< d curvature / ds of the one
    std::optional<double> change_after{};   ///< and of the other
    double curvature_noise = 0.0;           ///< of the two curvatures together
    double change_noise = 0.0;              ///< and of their changes
};

Meeting meeting_of(const Passing& before, const Passing& after);

/// The meeting run through the other way.
Meeting run_back(Meeting meeting);

/// How smooth a meeting of curves in a box of this diagonal is by its shape: -1 for a gap, 0 where only the points
/// agree, 1 where the directions do, 2 where the curvatures do, 3 where their changes do. Tolerances are those of
/// ContinuityTolerances, that of a change 1e-5 of the largest of both, of the square of a curvature and of 1 / size^2.
int smoothness_of(const Meeting& meeting, double size);

}  // namespace batten::core
