#include "render/camera.h"

#include <algorithm>
#include <limits>

namespace batten::render {
namespace {

constexpr glm::dvec2 up{1.0, -1.0};  // world y points up, screen y down

glm::dvec2 world_offset(const Camera& camera, glm::dvec2 screen_px) {
    return (screen_px - 0.5 * camera.size_px) * up / camera.scale;
}

}  // namespace

glm::dvec2 screen_from_world(const Camera& camera, glm::dvec2 world) {
    return 0.5 * camera.size_px + (world - camera.center) * up * camera.scale;
}

glm::dvec2 world_from_screen(const Camera& camera, glm::dvec2 screen_px) {
    return camera.center + world_offset(camera, screen_px);
}

Camera panned(const Camera& camera, glm::dvec2 offset_px) {
    Camera result = camera;
    result.center -= offset_px * up / camera.scale;
    return result;
}

Camera zoomed(const Camera& camera, double factor, glm::dvec2 anchor_px) {
    Camera result = camera;
    result.scale = std::clamp(camera.scale * factor, Camera::min_scale, Camera::max_scale);
    // The difference of two offsets rather than of two world points: the center may be far from the origin.
    result.center += world_offset(camera, anchor_px) - world_offset(result, anchor_px);
    return result;
}

Camera fitted(const Camera& camera, glm::dvec2 lower, glm::dvec2 upper, double margin_px) {
    Camera result = camera;
    result.center = 0.5 * lower + 0.5 * upper;
    double scale = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 2; ++axis) {
        const double extent = upper[axis] - lower[axis];
        const double room_px = std::max(camera.size_px[axis] - 2.0 * margin_px, 1.0);
        if (extent > 0.0) scale = std::min(scale, room_px / extent);
    }
    const bool is_point = !(upper.x > lower.x) && !(upper.y > lower.y);
    if (!is_point) result.scale = std::clamp(scale, Camera::min_scale, Camera::max_scale);
    return result;
}

}  // namespace batten::render
