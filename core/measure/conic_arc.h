/// A quadratic piece as lectures draw it: the arc of a conic between two tangents, and the rest of that conic.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/measure/conic_form.h"

namespace batten::core {

enum class ConicKind { ellipse, circle, parabola, hyperbola };

template <>
struct Names<ConicKind> {
    static constexpr std::array table{
        Named{ConicKind::ellipse, "ellipse", "ellipse"}, Named{ConicKind::circle, "circle", "circle"},
        Named{ConicKind::parabola, "parabola", "parabola"}, Named{ConicKind::hyperbola, "hyperbola", "hyperbola"}};
};

/// What counts as equal where a circle is recognized: a part of the legs' length, and of the weight.
inline constexpr double circle_tolerance = 1e-9;

/// The arc from P0 to P2 whose end tangents meet in P1, with the weights 1, w, 1.
struct ConicArc {
    ConicForm form;               ///< weight w, shoulder X, |MX| / |MP1| = w / (1 + w), equation
    std::array<Point, 3> points;  ///< P0, P1, P2
    ConicKind kind = ConicKind::parabola;
    Point chord_middle{};          ///< M, the middle of P0 and P2
    double half_angle = 0.0;       ///< a, half the angle at P1 between the legs, in degrees, above 0 and below 90
    std::array<double, 2> legs{};  ///< |P0P1| and |P1P2|
    std::optional<double> circular_weight;  ///< w = sin a makes an arc of 180 - 2a degrees; only of equally long legs
};

/// The arc of a piece of degree 2. It is a circle where the legs are equally long and w = sin a, within
/// circle_tolerance; else of the type of its conic_form. Errors as conic_form. Source: The NURBS Book, 7.3; Farin 2002,
/// chapter 12.
[[nodiscard]] Result<ConicArc> conic_arc(const BezierPiece& piece);

/// The conic without the arc, which is what the weight -w makes of the same points, as quadratic curves over [0, 1]
/// from P0 to P2: one for an ellipse, of two pieces; what goes to infinity is cut off where it is at least `reach`
/// (above 0, finite) away from P1, which leaves two for a parabola, and three for a hyperbola, whose other branch is in
/// the middle. Fewer where coordinates would be beyond what doubles can hold. Source: Farin 2002, chapter 12
/// (complementary segment).
std::vector<Curve> complement_of(const ConicArc& arc, double reach);

}  // namespace batten::core
