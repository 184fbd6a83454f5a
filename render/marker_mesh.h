/// Turns markers into squares on which the fragment shader finds the shape.
#pragma once

#include <glm/vec2.hpp>

#include "render/draw_list.h"
#include "render/mesh.h"
#include "render/pixel_box.h"

namespace batten::render {

struct MarkerVertex {
    glm::vec2 position_px{};
    glm::vec2 local_px{};    ///< from the center, in axes that make a diamond a square
    float roundness = 0.0F;  ///< 1 for a disc, 0 for a square
    float radius_px = 0.0F;  ///< of the disc, or half the side of the square
    float half_outline_px = 0.0F;
    Color fill;
    Color outline;
};

/// Adds `marker`, enlarged by `scale`, if it is seen in `visible` (framebuffer pixels): 4 vertices. Its outline is
/// solid.
void append_marker(Mesh<MarkerVertex>& mesh, const Marker& marker, const PixelBox& visible, double scale);

/// Whether the outline of the marker is a ring of dashes, which is painted as a polyline of its own.
bool has_dashed_ring(const Marker& marker);

/// The dashed outline of a disc: dashes and gaps are equal, start on the right and are fitted to go around a whole
/// number of times, so they are as close to `dash_px` as that allows. `scale` decides how many corners make it round.
Polyline dashed_ring(const Marker& marker, double scale);

}  // namespace batten::render
