/// The modes in which fit points and their handles are dragged.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

#include "app/editor/state/selection.h"
#include "core/base/geometry.h"

namespace batten::editor {

/// A fit point follows the pointer; or a new one does, pulled out of the curve.
struct DraggingFitPoint {
    std::size_t index = 0;
    core::Point start{};
    glm::dvec2 press_px{};
    bool is_new = false;
    bool has_moved = false;
};

/// An end of the handle of a given tangent follows the pointer; the other end lies opposite.
struct DraggingFitHandle {
    std::size_t index = 0;
    HandleEnd end = HandleEnd::ahead;
    core::Point start{};
    glm::dvec2 press_px{};
    bool has_moved = false;
};

}  // namespace batten::editor
