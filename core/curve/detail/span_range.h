/// A part of a curve that shares its polynomials, made without inserting a knot.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// The open curve over the spans first..last of the domain, with their knots, control points and weights: the same
/// polynomials over the same knots, its ends as they are, clamped or not. Cost: the copying.
Curve curve_over_spans(const Curve& curve, std::size_t first, std::size_t last);

}  // namespace batten::core
