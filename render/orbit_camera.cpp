#include "render/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace batten::render {
namespace {

/// Rows: to the right, up and toward the eye.
glm::dmat3 eye_from_space(const OrbitCamera& camera) {
    const double cos_yaw = std::cos(camera.yaw);
    const double sin_yaw = std::sin(camera.yaw);
    const double cos_pitch = std::cos(camera.pitch);
    const double sin_pitch = std::sin(camera.pitch);
    const glm::dvec3 right{cos_yaw, sin_yaw, 0.0};
    const glm::dvec3 ahead{-sin_yaw, cos_yaw, 0.0};
    const glm::dvec3 top{0.0, 0.0, 1.0};
    return glm::transpose(glm::dmat3(right, cos_pitch * top + sin_pitch * ahead, sin_pitch * top - cos_pitch * ahead));
}

/// A displacement in pixels.
glm::dvec2 shown(const OrbitCamera& camera, glm::dvec3 displacement) {
    const glm::dvec3 seen = eye_from_space(camera) * displacement;
    return camera.scale * glm::dvec2(seen.x, -seen.y);
}

}  // namespace

glm::dvec2 screen_from_space(const OrbitCamera& camera, glm::dvec3 place) {
    return camera.center_px + shown(camera, place - camera.target);
}

double nearness(const OrbitCamera& camera, glm::dvec3 place) {
    return (eye_from_space(camera) * (place - camera.target)).z;
}

OrbitCamera turned(const OrbitCamera& camera, glm::dvec2 drag_px) {
    OrbitCamera result = camera;
    result.yaw = std::remainder(camera.yaw - drag_px.x * OrbitCamera::radians_per_px, 2.0 * std::numbers::pi);
    result.pitch = std::clamp(camera.pitch + drag_px.y * OrbitCamera::radians_per_px, OrbitCamera::least_pitch,
                              OrbitCamera::greatest_pitch);
    return result;
}

std::optional<double> nearest_along(const OrbitCamera& camera, glm::dvec3 start, glm::dvec3 direction,
                                    glm::dvec2 position_px, double least_px) {
    const glm::dvec2 along = shown(camera, direction);
    const double squared = glm::dot(along, along);
    if (!(squared >= least_px * least_px)) return std::nullopt;
    return glm::dot(position_px - screen_from_space(camera, start), along) / squared;
}

}  // namespace batten::render
