/// The mode in which the handlebar is dragged.
#pragma once

#include <glm/vec2.hpp>

#include "app/editor/state/selection.h"
#include "core/base/geometry.h"

namespace batten::editor {

/// The curve follows the part of the handlebar that was grabbed: its middle with the tangent, where that can be kept,
/// or an end of the tangent.
struct DraggingHandlebar {
    HandlebarPart part = HandlebarPart::middle;
    core::Point start{};  ///< where the part was
    glm::dvec2 press_px{};
    bool keeps_tangent = false;
    bool has_moved = false;
};

}  // namespace batten::editor
