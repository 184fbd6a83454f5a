/// Edits of the knot vector that keep the control points and so change the shape.
#pragma once

#include "core/base/names.h"
#include "core/curve/curve.h"

namespace batten::core {

/// What a moved knot does when it meets its neighbors.
enum class KnotMove {
    stop,  ///< stops before the neighboring knot, never joining it
    push,  ///< takes the neighbors along, never joining them; the ends of the domain are pushed by no knot inside it
    snap   ///< stops at the neighboring knot's value, joining its stack while the multiplicity allows; jumps onto a
           ///< knot not farther than the snap distance, and out of a stack only beyond it
};

template <>
struct Names<KnotMove> {
    static constexpr std::array table{Named{KnotMove::stop, "stop", "stop"}, Named{KnotMove::push, "push", "push"},
                                      Named{KnotMove::snap, "snap", "snap"}};
};

/// The curve with knot `index` of stored() moved to `u`, taking `mode` and, for snap, the `snap_distance` (in
/// parameter units, >= 0). The number of knots and all control points stay. Moving one knot of a stack takes the one
/// at the side it is moved to, so a stack is pulled apart one by one. The kind becomes custom, unless nothing moves.
///
/// What is not joined (a neighbor in `stop`, a stack that is full, an end that would leave no domain) is approached to
/// 1/200 of the domain, or to a tenth of the way from the knot before where that is less; not at all by a knot that is
/// nearer already. With `tears` a stack of p inside the domain of an open curve
/// takes one knot more, and the curve comes apart there. Pushed neighbors keep their distance, or that much of it.
/// End knots move like others, which moves the domain. In a periodic curve t_0 and t_n are one knot and move
/// together, so the period keeps its length; pushing, they move by at most one period.
/// Errors: knot_index_out_of_range; parameter_not_finite.
[[nodiscard]] Result<Curve> move_knot(const Curve& curve, std::size_t index, double u, KnotMove mode,
                                      double snap_distance = 0.0, Tears tears = Tears::refuse);

/// The curve with knot `index` of stored() set to exactly `u`, as typed. Of a stack, the knot at that side is taken. In
/// a periodic curve the end of the period named by `index` is set alone, which changes the length of the period. With
/// `tears` a knot inside the domain of an open curve may have multiplicity p+1.
/// Errors: knot_index_out_of_range; parameter_not_finite; knot_decreasing when `u` is not between the neighbors;
/// multiplicity_too_high; domain_empty.
[[nodiscard]] Result<Curve> set_knot(const Curve& curve, std::size_t index, double u, Tears tears = Tears::refuse);

/// The curve without knot `index` of stored() and without the control point it carries most (the one whose Greville
/// abscissa is nearest to the knot, never an end point of a clamped curve). Deleting the seam of a periodic curve
/// makes the next knot the seam and keeps the period. Errors: knot_index_out_of_range; knot_not_removable.
[[nodiscard]] Result<Curve> delete_knot(const Curve& curve, std::size_t index);

/// The curve over new knots of `kind`, same points and domain. For custom the values stay and only the kind changes.
/// Errors: those of make_knots.
[[nodiscard]] Result<Curve> set_knot_kind(const Curve& curve, KnotKind kind);

/// The curve over equally spaced knots, same points and domain: periodic stays periodic, clamped at both ends stays so,
/// everything else becomes uniform without clamped ends.
[[nodiscard]] Result<Curve> make_uniform(const Curve& curve);

/// The curve over `knots` (one period when periodic), same degree, points and weights; the kind becomes custom. A torn
/// curve may be torn again, others with `tears`. Errors: those of KnotVector::make and knot_count_mismatch.
[[nodiscard]] Result<Curve> set_knots(const Curve& curve, std::vector<double> knots, Tears tears = Tears::refuse);

/// The closed curve through wrapped use of the same control points (uniform periodic knots over the same domain), or
/// the open clamped uniform one. Shape-changing. Error: too_few_points.
[[nodiscard]] Result<Curve> set_periodic(const Curve& curve, bool periodic);

}  // namespace batten::core
