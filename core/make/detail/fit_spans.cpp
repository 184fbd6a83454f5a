#include "core/make/detail/fit_spans.h"

namespace batten::core {

// That of the parabola through the point and its two neighbors. Source: Bessel; de Boor 1978, chapter IV.
Vector FitSpans::local_derivative(std::size_t i) const {
    const std::size_t before = i == 0 ? point_count() - 1 : i - 1;
    const double way_in = length(before);
    const double way_out = length(i);
    const double share = way_in / (way_in + way_out);
    return (1.0 - share) * slope(before) + share * slope(i);
}

JointNeeds FitSpans::needs(std::size_t i) const {
    const FitPoint& point = fit_.points[i];
    const bool has_left = fit_.closed || i > 0;
    const bool has_right = fit_.closed || i + 1 < point_count();
    const std::size_t before = i == 0 ? point_count() - 1 : i - 1;
    const bool comes_straight = has_left && is_straight(fit_.points[before].joint);
    const bool goes_straight = has_right && is_straight(point.joint);
    const bool has_tangent = point.joint == FitJoint::tangent;
    JointNeeds needs;
    needs.is_corner = point.joint == FitJoint::corner || (has_right && point.joint == FitJoint::corner_straight) ||
                      (comes_straight && (goes_straight || has_tangent));
    if (has_tangent) needs.left = needs.right = derivative_of_handle(fit_, i);
    if (goes_straight) needs.right = slope(i);
    if (comes_straight) needs.left = slope(before);
    if (!needs.is_corner && goes_straight) needs.left = needs.right;
    if (!needs.is_corner && comes_straight) needs.right = needs.left;
    const bool is_inside = has_left && has_right;
    if (fit_.kind == FitKind::local && is_inside && !needs.is_corner && !needs.left)
        needs.left = needs.right = local_derivative(i);
    needs.is_break = !is_inside || needs.is_corner || needs.left || needs.right;
    return needs;
}

}  // namespace batten::core
