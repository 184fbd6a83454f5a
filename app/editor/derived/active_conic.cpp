#include "app/editor/derived/active_conic.h"

#include <fmt/core.h>

#include <cmath>

#include "app/editor/words/number_column.h"

namespace batten::editor {

namespace {

std::string conic_point_name(const core::Curve& curve, std::size_t index) {
    return fmt::format("P_{{{}}}", index % curve.control_points().size());
}

std::string curve_point_name(const core::Curve& curve, double u) {
    return fmt::format("C({})", parameter_text(curve, u));
}

}  // namespace

core::Result<ActiveConic> active_conic(const core::Curve& curve, double u) {
    if (curve.degree() != 2)
        return core::refuse({.code = core::CurveErrorCode::degree_unsuitable,
                             .value = static_cast<double>(curve.degree()),
                             .lower = 2.0});
    const core::KnotVector& knots = curve.knots();
    const std::size_t span = knots.span_at(knots.into_domain(u));
    const core::BezierPiece piece = core::bezier_piece(curve, span);
    const auto arc = core::conic_arc(piece);
    if (!arc) return tl::unexpected(arc.error());
    const bool begins_in_point = knots.multiplicity(piece.interval.lower) >= 2;
    const bool ends_in_point = knots.multiplicity(piece.interval.upper) >= 2;
    return ActiveConic{
        .arc = *arc,
        .corner = (span - 1) % curve.control_points().size(),
        .end_scale = std::sqrt(piece.points[0].z) * std::sqrt(piece.points[2].z),
        .has_own_ends = begins_in_point && ends_in_point,
        .names = {begins_in_point ? conic_point_name(curve, span - 2) : curve_point_name(curve, piece.interval.lower),
                  conic_point_name(curve, span - 1),
                  ends_in_point ? conic_point_name(curve, span) : curve_point_name(curve, piece.interval.upper)}};
}

}  // namespace batten::editor
