/// Turns ink into rectangles over what is covered.
#pragma once

#include <glm/vec2.hpp>

#include "render/draw_list.h"
#include "render/fill_mesh.h"
#include "render/mesh.h"

namespace batten::render {

struct InkVertex {
    glm::vec2 position_px{};
    glm::vec2 place{};  ///< in the touched part of the map, from (0, 0) to (1, 1)
    Color color;
};

/// Adds `ink`, enlarged by `scale`: rectangles of tiles that are all covered to `covered`, of those that are so in part
/// to `mixed`. Cost: the touched pixels.
void append_ink(Mesh<FillVertex>& covered, Mesh<InkVertex>& mixed, const Ink& ink, double scale);

}  // namespace batten::render
