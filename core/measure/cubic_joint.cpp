#include "core/measure/cubic_joint.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/measure/closing.h"
#include "core/measure/collinear.h"

namespace batten::core {

namespace {

std::array<Point, 3> vertices_of(const Anticentroid& joint) {
    return {joint.before, joint.vertex, joint.after};
}

void include(Box& box, const Anticentroid& joint) {
    for (const Point& vertex : vertices_of(joint)) box.include(vertex);
}

int common_derivatives(const Anticentroid& first, const Anticentroid& second) {
    Box box;
    include(box, first);
    include(box, second);
    const double tolerance = absolute_tolerance(box, default_closing_tolerance);
    if (!(distance(first.anticentroid, second.anticentroid) <= tolerance)) return -1;
    if (!(length(first.tangent - second.tangent) <= 6.0 * tolerance)) return 0;
    return length(first.second_derivative - second.second_derivative) <= 6.0 * tolerance ? 2 : 1;
}

double knot_step(const Curve& curve) {
    const Interval domain = curve.domain();
    return domain.length() / static_cast<double>(cubic_segment_count(curve));
}

bool are_equal_steps(double a, double b) {
    return std::abs(a - b) <= default_closing_tolerance * std::max(a, b);
}

}  // namespace

CubicJointCase case_of(const Anticentroid& joint) {
    using enum CubicJointCase;
    Box box;
    include(box, joint);
    const double tolerance = absolute_tolerance(box, default_collinear_tolerance);
    const auto are_equal = [&](Point a, Point b) { return robust_length(b - a) <= tolerance; };
    const bool equals_before = are_equal(joint.before, joint.vertex);
    const bool equals_after = are_equal(joint.vertex, joint.after);
    if (equals_before && equals_after) return tripled;
    if (equals_before || equals_after) return doubled;
    if (are_equal(joint.before, joint.after)) return folded;
    if (are_equal(joint.base_middle, joint.vertex)) return centered;
    return are_collinear(vertices_of(joint)) ? collinear : triangle;
}

bool is_straight_segment(const Curve& curve, std::size_t k) {
    const auto points = curve.control_points();
    std::array<Point, 4> of_segment;
    for (std::size_t j = 0; j < 4; ++j) of_segment[j] = points[(k + j) % points.size()];
    return are_collinear(of_segment);
}

CubicMeeting meeting_of_cubics(const Curve& first, const Curve& second) {
    assert(!first.is_periodic() && !second.is_periodic());
    const Anticentroid last_joint = anticentroid(first, first.control_points().size() - 2);
    const Anticentroid first_joint = anticentroid(second, 1);
    return {.first = last_joint,
            .second = first_joint,
            .continuity = common_derivatives(last_joint, first_joint),
            .has_equal_steps = are_equal_steps(knot_step(first), knot_step(second))};
}

}  // namespace batten::core
