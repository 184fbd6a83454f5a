/// What lights up together: the linked parts of curve, points, knots and basis functions.
#pragma once

#include <vector>

#include "app/editor/state/state.h"
#include "core/base/geometry.h"

namespace batten::editor {

/// Parts of the active curve that belong to what is hovered. Indices ascend without repeats.
struct Highlight {
    std::vector<std::size_t> points;    ///< control points
    std::vector<std::size_t> basis;     ///< basis functions, which are numbered as the points
    std::vector<std::size_t> knots;     ///< indices in stored(); both ends of the period for the seam
    std::vector<core::Interval> parts;  ///< parameters of the curve, each inside the domain and not empty
    bool shows_hull = false;            ///< the hull of `points`

    bool is_empty() const { return points.empty() && knots.empty() && parts.empty(); }
};

/// What belongs to the hovered part of the shown active curve of degree p with n points:
///
/// - Control point, weight ring or basis function i: point i, N_i, its p+2 knots u_i..u_{i+p+1}, and its support
///   [u_i, u_{i+p+1}] cut to the domain; two parts where a periodic support runs over the seam.
/// - Knot: the run u_a = ... = u_b of equal knots is one thing. Its knots, the non-empty spans [u_{a-1}, u_a] and [u_b,
/// u_{b+1}] as
///   far as they are in the domain, and the points and functions a-p-1..b, whose p+2 knots include one of the run;
///   these are also the points of the two spans.
/// - Cell P_i^r of the construction at the view's parameter: the points i-r..i of which it is a combination, and the
/// two
///   knots that make its alpha, u_i and u_{i+p-r+1}.
/// - N_{i,k} of the recurrence: its k+2 knots u_i..u_{i+k+1}; for k = p as its control point.
/// - Control point i of the hodograph of order r: the points i..i+r, of whose difference it is a multiple.
/// - Span s: the points and functions s-p..s, the hull of the points, and the part [u_s, u_{s+1}].
///
/// Anything else, or an index that the curve does not have: nothing.
Highlight highlight(const EditorState& state);

/// What belongs to control point `i` of `curve`.
Highlight highlight_of_point(const core::Curve& curve, std::size_t i);

}  // namespace batten::editor
