/// Elliptical arcs as paths of SVG name them: by their ends, radii, and which of the four arcs between them is meant.
#pragma once

#include <vector>

#include "core/base/double_double.h"
#include "core/base/geometry.h"

namespace batten::exchange {

/// An arc from one point to another. "Positive" angles turn from x to y.
struct EndpointArc {
    core::Point from{};
    core::DoubleDouble first_radius{};
    core::DoubleDouble second_radius{};
    core::DoubleDouble rotation{};  ///< of the first radius, in degrees
    bool is_large = false;          ///< more than half of the ellipse
    bool is_positive = false;
    core::Point to{};
    core::Vector rest{};  ///< what the way between the ends, which are rounded, lacks of the way that is meant
};

/// A quadratic piece with the weights 1, `weight`, 1, which goes on from where the one before ends.
struct ConicPiece {
    core::Point corner{};
    double weight = 1.0;
    core::Point end{};
};

/// The arc in the fewest equal pieces of at most 90 degrees, right to rounding also where it is nearly straight or
/// nearly half of its ellipse; it ends in `to`, bit-equal. Radii that are too small for their ends grow as SVG 2 says.
/// None where a radius is 0 or not finite, which means a line, or the ends are equal, which means nothing. Source:
/// SVG 2, appendix B.2.
std::vector<ConicPiece> conic_pieces(const EndpointArc& arc);

}  // namespace batten::exchange
