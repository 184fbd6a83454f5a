#include "core/evaluate/de_boor.h"

#include "core/curve/detail/bspline.h"
#include "core/curve/knot_analysis.h"

namespace batten::core {

namespace {

using Level = std::vector<DeBoorCell>;

Level control_point_level(const Curve& curve, const SpanKnots& at) {
    Level level;
    for (std::size_t i = at.s - at.p; i <= at.s; ++i) {
        const std::size_t k = i % curve.control_points().size();
        level.push_back({.index = i, .point = curve.control_points()[k], .weight = curve.weights()[k]});
    }
    return level;
}

// The shadow of `blended`, except that a point which takes all of one parent is that parent, to the last bit.
Point shadow(const HomogeneousPoint& blended, const DeBoorCell& lower, const DeBoorCell& upper, double alpha) {
    if (alpha == 0.0) return lower.point;
    if (alpha == 1.0) return upper.point;
    return project(blended);
}

// The cells of level r from the homogeneous points of that level and the cells below.
Level blended_level(const LocalPoints<HomogeneousPoint>& points, const Level& below, const SpanKnots& at, std::size_t r,
                    double u) {
    Level level;
    for (std::size_t j = r; j <= at.p; ++j) {
        const double alpha = at.ratio(j, r, u).upper_share;
        const std::size_t i = at.s - at.p + j;
        level.push_back({.index = i,
                         .point = shadow(points[j], below[j - r], below[j - r + 1], alpha),
                         .weight = points[j].z,
                         .alpha = alpha,
                         .lower_knot = i,
                         .upper_knot = i + at.p - r + 1});
    }
    return level;
}

}  // namespace

DeBoorTriangle de_boor_triangle(const Curve& curve, double u, Side side) {
    const auto [inside, at] = located(curve.knots(), u, side);
    DeBoorTriangle triangle{.u = inside, .span = at.s, .levels = {control_point_level(curve, at)}};
    auto points = local_points(curve, at);
    for (std::size_t r = 1; r <= at.p; ++r) {
        blend_level(points, at, r, inside);
        triangle.levels.push_back(blended_level(points, triangle.levels.back(), at, r, inside));
    }
    return triangle;
}

Result<DeBoorTriangle> de_casteljau_triangle(const Curve& curve, double u) {
    if (!is_of_kind(curve.knots(), KnotKind::bezier))
        return refuse({.code = CurveErrorCode::curve_not_polynomial_piece});
    return de_boor_triangle(curve, u);
}

}  // namespace batten::core
