/// One cubic in place of a piece of a curve.
#pragma once

#include <array>

#include "core/curve/curve.h"

namespace batten::exchange {

/// A polynomial cubic, and how far it is from the curve that it stands for.
struct CubicFit {
    std::array<core::Point, 4> points{};
    double error = 0.0;  ///< no point of the curve is farther from the cubic, nor the other way round
};

/// The cubic from the first to the last point of `piece`, a Bézier curve, with its tangents there. The error is bounded
/// by control points of the difference of both, in which the parameter of the cubic is matched to that of the curve, a
/// few times halved until the bound is within `wanted`; the rounding of these steps is in it. It is infinite where
/// numbers are beyond doubles. Cost O(p^2).
CubicFit cubic_fit(const core::Curve& piece, double wanted);

/// The Bézier curve with the same points that draws the same by a parameter from 0 to 1 of its own (a linear rational
/// one), in which the weights of both ends are nearly equal: halves of it are halves of what is seen. Weights are
/// changed by powers of two, hence exactly; it is `piece` where they would be beyond doubles.
core::Curve with_even_ends(const core::Curve& piece);

}  // namespace batten::exchange
