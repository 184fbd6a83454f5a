/// Space seen from a direction that is turned, by parallel rays; z points up.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <optional>

namespace batten::render {

/// Looks at `target`, which is shown at `center_px`. With both angles 0 it looks along y: x to the right, z up; with a
/// pitch of a right angle straight down: x to the right, y up.
struct OrbitCamera {
    double yaw = 0.0;    ///< radians by which the eye has gone around z, counterclockwise seen from above
    double pitch = 0.0;  ///< radians by which it has risen, within pitches
    double scale = 1.0;  ///< pixels of a unit of length, > 0
    glm::dvec3 target{0.0, 0.0, 0.0};
    glm::dvec2 center_px{0.0, 0.0};

    static constexpr double least_pitch = -0.5 * std::numbers::pi;
    static constexpr double greatest_pitch = 0.5 * std::numbers::pi;
    static constexpr double radians_per_px = 0.01;  ///< a full turn for 628 pixels

    bool operator==(const OrbitCamera&) const = default;
};

/// Where a place is in the picture, in pixels.
glm::dvec2 screen_from_space(const OrbitCamera& camera, glm::dvec3 place);

/// How near the eye a place is beside the target: what is greater is in front.
double nearness(const OrbitCamera& camera, glm::dvec3 place);

/// The camera after a drag by `drag_px`, design pixels: what is in front follows the pointer. The pitch stays within
/// its bounds.
OrbitCamera turned(const OrbitCamera& camera, glm::dvec2 drag_px);

/// The t for which the place start + t direction is shown nearest to `position_px`; none where the direction is seen
/// so much from its end that a pixel says nothing, less than `least_px` for t = 1.
std::optional<double> nearest_along(const OrbitCamera& camera, glm::dvec3 start, glm::dvec3 direction,
                                    glm::dvec2 position_px, double least_px = 4.0);

}  // namespace batten::render
