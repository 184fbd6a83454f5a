/// Turns an image into the part of its parallelogram that is seen.
#pragma once

#include <glm/vec2.hpp>

#include "render/draw_list.h"
#include "render/mesh.h"
#include "render/pixel_box.h"

namespace batten::render {

struct ImageVertex {
    glm::vec2 position_px{};
    glm::vec2 place{};  ///< in the image, from (0, 0) to (1, 1)
    float opacity = 1.0F;
};

/// Adds `quad`, enlarged by `scale`, as far as it lies in `visible`; nothing where it has no area.
void append_image(Mesh<ImageVertex>& mesh, const ImageQuad& quad, const PixelBox& visible, double scale);

}  // namespace batten::render
