#include "core/edit/circular.h"

#include <cmath>

#include "core/curve/detail/edit_checks.h"
#include "core/edit/point_edit.h"
#include "core/measure/conic_arc.h"

namespace batten::core {

Result<Curve> make_circular(const Curve& curve, double u) {
    if (curve.degree() != 2)
        return refuse(
            {.code = CurveErrorCode::degree_unsuitable, .value = static_cast<double>(curve.degree()), .lower = 2.0});
    if (auto check = check_parameter_finite(u); !check) return tl::unexpected(check.error());
    const KnotVector& knots = curve.knots();
    if (const auto check = check_in_domain(knots, u); !check) return refuse(check.error());
    const std::size_t span = knots.span_at(u);
    if (knots.multiplicity(knots[span]) < 2 || knots.multiplicity(knots[span + 1]) < 2)
        return refuse({.code = CurveErrorCode::piece_not_bezier, .value = u});
    const BezierPiece piece = bezier_piece(curve, span);
    const auto arc = conic_arc(piece);
    if (!arc) return tl::unexpected(arc.error());
    if (!arc->circular_weight)
        return refuse({.code = CurveErrorCode::legs_unequal, .value = arc->legs[0], .upper = arc->legs[1]});
    const double scale = std::sqrt(piece.points[0].z) * std::sqrt(piece.points[2].z);
    return set_weight(curve, (span - 1) % curve.control_points().size(), scale * *arc->circular_weight);
}

}  // namespace batten::core
