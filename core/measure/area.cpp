#include "core/measure/area.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "core/curve/control_box.h"
#include "core/measure/continuity.h"
#include "core/measure/detail/piece_integral.h"

namespace batten::core {

namespace {

// Parts whose error is less than this share of size^2 are done.
constexpr double enough_area = 1e-16;

constexpr double area_rounding = 16.0 * std::numeric_limits<double>::epsilon();

// det(C, C') times (1, x, y): what is integrated for the area and both moments.
glm::dvec3 moments_at(std::span<const PieceMotion> pieces, HalfPlace place) {
    const auto [position, velocity] = motion_at(pieces, place);
    const double swept = cross(vector_to(position), velocity);
    return {swept, swept * position.x, swept * position.y};
}

// The largest part of the curve's size, of its square and of its cube that an entry is allowed to be off.
double error_of(const RulePair<glm::dvec3>& rules, double size) {
    const glm::dvec3 difference = glm::abs(rules.kronrod - rules.gauss) / glm::dvec3(1.0, size, size);
    const double largest = std::max({difference.x, difference.y, difference.z}) / (size * size);
    return std::min(largest, std::pow(200.0 * largest, 1.5)) * size * size;
}

bool is_torn(const Curve& curve) {
    const auto joints = joint_continuity(curve);
    return std::any_of(joints.begin(), joints.end(), [](const JointContinuity& joint) { return joint.geometric < 0; });
}

}  // namespace

Result<Area> enclosed_area(const Curve& curve) {
    if (!is_closed(curve) || is_torn(curve)) return refuse({.code = CurveErrorCode::curve_not_closed});
    const Point origin = middle_of(curve);
    const Vector extent = control_box(curve).size();
    const double size = std::max(extent.x, extent.y);
    if (size == 0.0) return Area{};
    const auto pieces = motions_of(curve, origin);
    const auto parts = integrate_adaptively<glm::dvec3>(
        ranges_between(pieces, curve.domain()),
        [&](std::size_t half, double offset) {
            return moments_at(pieces, {half, offset});
        },
        [&](std::size_t, const RulePair<glm::dvec3>& rules) { return error_of(rules, size); },
        [&](double error, const glm::dvec3&) { return !(error > enough_area * size * size); });
    glm::dvec3 sum(0.0);
    double error = area_rounding * size * size;
    for (const auto& part : parts) {
        sum += part.rules.kronrod;
        error += part.error;
    }
    Area area{0.5 * sum.x, 0.5 * error, std::nullopt};
    if (std::abs(area.signed_area) > 4.0 * area.error)
        area.centroid = origin + Vector(sum.y, sum.z) / (3.0 * area.signed_area);
    return area;
}

}  // namespace batten::core
