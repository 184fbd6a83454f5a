/// A guide that follows the pointer.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

namespace batten::editor {

struct DraggingGuide {
    std::size_t index = 0;
    glm::dvec2 press_px{};
    bool has_moved = false;
};

}  // namespace batten::editor
