/// The curve over given knots that is nearest to another curve (shape-changing).
#pragma once

#include <span>

#include "core/base/progress.h"
#include "core/curve/approximation.h"

namespace batten::core {

/// The curve with the knots and weights of `pattern` and the control points that make
///     integral |C(u) - T(u)|^2 du
/// least, where T is `truth`, a curve over the same domain of any degree. The ends stay where those of the pattern are,
/// and where the pattern is smoother at a knot than its multiplicity promises, it stays so, G1 and G2. Control points
/// of the pattern that are those of `truth`, over the same knots, and more than 2p away from the first and the last
/// that are not, keep every bit. The error is a bound of the largest distance at equal parameters. Errors:
/// not_computable. Cost O((m + n) p^2) for m and n control points.
[[nodiscard]] Result<Approximation> refit(const Curve& pattern, const Curve& truth, const Progress& progress = {});

/// The curve without the control points `indices` (distinct, any order) and without as many knots, as
/// delete_control_points() takes them out, that is nearest to the whole curve. Errors: those of delete_control_points
/// and of refit.
[[nodiscard]] Result<Approximation> delete_points_and_refit(const Curve& curve, std::span<const std::size_t> indices,
                                                            const Progress& progress = {});

}  // namespace batten::core
