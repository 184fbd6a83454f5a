/// A picture dragged on the canvas.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

namespace batten::editor {

/// A picture that is not locked follows the pointer.
struct DraggingPicture {
    std::size_t index = 0;
    glm::dvec2 press_px{};
    bool has_moved = false;
};

}  // namespace batten::editor
