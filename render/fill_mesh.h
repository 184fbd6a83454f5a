/// Turns filled convex polygons into a fan of triangles with soft edges.
#pragma once

#include <glm/vec2.hpp>

#include "render/draw_list.h"
#include "render/mesh.h"
#include "render/pixel_box.h"

namespace batten::render {

struct FillVertex {
    glm::vec2 position_px{};
    float inside_px = 0.0F;  ///< distance to the edge of the triangle's polygon side, negative outside
    Color color;
};

/// Adds `fill`, enlarged by `scale`, as far as it is seen in `visible` (framebuffer pixels): 2 vertices and 1 triangle
/// for a side. A polygon without area adds nothing.
void append_fill(Mesh<FillVertex>& mesh, const Fill& fill, const PixelBox& visible, double scale);

}  // namespace batten::render
