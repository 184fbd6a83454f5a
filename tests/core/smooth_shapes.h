/// Curves that are smoother by their shape than by their knots.
#pragma once

#include "core/measure/smoothness.h"
#include "core/refine/bezier_form.h"
#include "tests/core/shape_check.h"

namespace batten::core {

/// A clamped curve of this degree, at least 2, with simple knots, as piecewise Bézier curve whose pieces take other
/// parts of the domain than they had: so it is G2 (G1 in degree 2) by its shape, and C0 by its knots and its
/// derivatives.
inline Curve smooth_by_shape(int degree, std::size_t spans, RandomCurves& random) {
    CurveDefinition definition = to_bezier(high_degree_curve(degree, spans, random)).value().definition();
    for (double& knot : definition.knots) knot += 0.3 * knot * knot;
    definition.kind = KnotKind::custom;
    return Curve::make(std::move(definition)).value();
}

}  // namespace batten::core
