/// The similarity between the plane of the curves and the pixels of a picture.
#pragma once

#include <glm/vec2.hpp>

namespace batten::render {

/// Looks at `center` with `scale` pixels to a unit; world y points up, screen y down. All in doubles, so that zooming
/// is steady over twelve decades: a world point is subtracted from the center before it is scaled.
struct Camera {
    glm::dvec2 center{0.0, 0.0};
    double scale = 64.0;                ///< pixels per world unit, within [min_scale, max_scale]
    glm::dvec2 size_px{1280.0, 720.0};  ///< of the picture

    static constexpr double min_scale = 1e-9;
    static constexpr double max_scale = 1e15;

    bool operator==(const Camera&) const = default;
};

/// Where a world point is in the picture, in pixels.
glm::dvec2 screen_from_world(const Camera& camera, glm::dvec2 world);

/// The world point under a pixel; inverse of screen_from_world.
glm::dvec2 world_from_screen(const Camera& camera, glm::dvec2 screen_px);

/// The camera moved so that the picture's content shifts by `offset_px`.
Camera panned(const Camera& camera, glm::dvec2 offset_px);

/// The camera with `factor` times the scale (clamped to the limits) and the same world point under `anchor_px`.
Camera zoomed(const Camera& camera, double factor, glm::dvec2 anchor_px);

/// The camera that shows the rectangle [lower, upper] centered with `margin_px` (0..) free on each side. A rectangle
/// without width and height is only centered.
Camera fitted(const Camera& camera, glm::dvec2 lower, glm::dvec2 upper, double margin_px);

}  // namespace batten::render
