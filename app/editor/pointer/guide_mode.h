/// Guides that follow the pointer.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

namespace batten::editor {

/// Dropped on a ruler it is removed.
struct DraggingGuide {
    std::size_t index = 0;
    glm::dvec2 press_px{};
    bool has_moved = false;
};

/// A new guide, dragged out of a ruler; dropped on one there is none.
struct PullingGuide {
    double angle = 0.0;  ///< 0 out of the upper ruler, 90 out of the left one
    glm::dvec2 press_px{};
    bool has_moved = false;
};

}  // namespace batten::editor
