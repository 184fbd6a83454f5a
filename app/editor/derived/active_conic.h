/// The conic of the quadratic piece at the parameter, and what of the curve decides it.
#pragma once

#include <array>
#include <string>

#include "core/curve/curve.h"
#include "core/measure/conic_arc.h"

namespace batten::editor {

/// The arc over the span that holds the parameter.
struct ActiveConic {
    core::ConicArc arc;
    std::size_t corner = 0;            ///< the control point in which the end tangents meet
    double end_scale = 1.0;            ///< root(w0 w2) of the piece: its corner weighs w root(w0 w2)
    bool has_own_ends = false;         ///< they are control points, which the corner's weight does not move
    std::array<std::string, 3> names;  ///< "P_{0}", or "C(0.25)" for an end that is no control point
};

/// The conic of `curve` at `u`, brought into the domain. Errors as core::conic_arc. Cost O(log n).
core::Result<ActiveConic> active_conic(const core::Curve& curve, double u);

}  // namespace batten::editor
