/// Conditions under which moved control points leave a curve as smooth at its knots as it is by its shape.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/curve/curve.h"
#include "core/evaluate/rational_basis.h"

namespace batten::core {

/// One linear condition on the moves D_i of the control points of the unrolled curve:
/// sum of coefficients[j] D_{first + j} = right. Behind the last point of an open curve that is closed comes its first.
struct MoveCondition {
    std::size_t first = 0;
    std::vector<double> coefficients{};
    Vector right{};
};

/// The functions of both sides of a knot as one row, that of `after` less `factor` times that of `before`, each of its
/// own order.
MoveCondition difference_at_knot(const Curve& curve, const RationalBasis& before, std::size_t before_order,
                                 const RationalBasis& after, std::size_t after_order, double factor = 1.0);

/// For every knot in `range` at which the curve is smoother by its shape than by its knots: that the moves are related
/// there as the curve is (joint_relation), so that it stays G1 and G2. Where `range` is the domain, ends that meet are
/// such a joint, too; they stay together, and so do the sides of a tear. Kept is G2 at most, and no more than G^(p-1),
/// beyond which pieces could not be moved by themselves. No condition on directions where the curve stands still, none
/// where all moves keep it, as those of a closed curve of two points, which stays on a line, and none for a curve that
/// is a single point. Cost O(p^3) for each of these knots, and O(n).
std::vector<MoveCondition> smoothness_conditions(const Curve& curve, Interval range);

/// The curve with the least sum of squared moves of control points which leaves it as smooth at its knots as it is, for
/// which C(u), and as the case may be C'(u) seen from `side`, move by `moves`, one or two. Only points move that act
/// no further from u than the p+1 functions of simple knots would; of a periodic curve, and of a closed one near whose
/// ends u lies, all. None where the knots alone
/// keep the smoothness of what acts at u, or where it cannot be kept.
/// The control points `pinned` (ascending) stay.
std::optional<Curve> moved_smoothly(const Curve& curve, double u, Side side, std::span<const Vector> moves,
                                    std::span<const std::size_t> pinned = {});

/// The curve with its control points moved.
Result<Curve> with_moves(const Curve& curve, std::size_t first, std::span<const Vector> moves);

}  // namespace batten::core
