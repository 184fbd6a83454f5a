/// What sort of conic a rational quadratic piece is, and its implicit equation.
#pragma once

#include "core/base/names.h"
#include "core/evaluate/bezier_pieces.h"

namespace batten::core {

enum class ConicType { ellipse, parabola, hyperbola };

template <>
struct Names<ConicType> {
    static constexpr std::array table{Named{ConicType::ellipse, "ellipse", "ellipse"},
                                      Named{ConicType::parabola, "parabola", "parabola"},
                                      Named{ConicType::hyperbola, "hyperbola", "hyperbola"}};
};

/// A X^2 + B XY + C Y^2 + D X + E Y + F with (X, Y) = (x, y) - origin; zero along the conic. The largest of |A|, |B|,
/// |C| is 1, and the first of them that is not zero is positive.
struct ImplicitConic {
    Point origin{};
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
    double d = 0.0;
    double e = 0.0;
    double f = 0.0;

    double value_at(Point point) const;

    /// The same equation seen from another origin, (0, 0) for the one of the textbooks; digits are lost when that is
    /// far from the conic.
    ImplicitConic seen_from(Point new_origin) const;
};

/// One quadratic piece as a conic.
struct ConicForm {
    Interval interval;  ///< where in the curve's domain
    ConicType type = ConicType::parabola;
    double weight = 1.0;  ///< w = w1 / sqrt(w0 w2), the middle weight when the others are 1; below 1 an ellipse
    /// The shoulder point, where the tangent is parallel to the chord, divides the way from the middle of the chord to
    /// the corner in the ratio w / (1 + w): 1/2 for a parabola.
    double shoulder_ratio = 0.5;
    Point shoulder{};
    ImplicitConic equation;
};

/// The conic of a piece of degree 2; weights within a few units in their last place of a parabola's make a parabola.
/// Errors: degree_unsuitable unless the degree is 2; points_collinear when the piece is straight. Source: Lee 1987,
/// The rational Bézier representation for conics; Farin 2002, chapter 12.
[[nodiscard]] Result<ConicForm> conic_form(const BezierPiece& piece);

}  // namespace batten::core
