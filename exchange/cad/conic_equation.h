/// The arc of a conic that is given by its equation and its ends, as IGES has them (entity 104).
#pragma once

#include <string>

#include "core/curve/curve.h"

namespace batten::exchange {

/// A x^2 + B xy + C y^2 + D x + E y + F = 0.
struct ConicEquation {
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
    double d = 0.0;
    double e = 0.0;
    double f = 0.0;
};

/// What a file calls a conic. Its coefficients decide, but where they may be rounded ones of a parabola.
enum class ConicName { none, ellipse, hyperbola, parabola };

struct ConicArcOfEquation {
    core::Curve curve;
    double error = 0.0;  ///< how far a point of the curve is from the conic, at most
};

/// The arc from `start` to `end`: on an ellipse counter-clockwise, in pieces of at most a right angle, and whole where
/// both are one point; else one piece, polynomial for a parabola. Its ends are those that were given, though they may
/// lie beside the conic, which the error tells. Or the reason why there is none, as a part of a sentence.
[[nodiscard]] tl::expected<ConicArcOfEquation, std::string> arc_of_equation(const ConicEquation& equation,
                                                                            ConicName name, core::Point start,
                                                                            core::Point end);

}  // namespace batten::exchange
