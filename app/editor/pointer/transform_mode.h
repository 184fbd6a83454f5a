/// A grip of the transform box that follows the pointer.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "app/editor/state/transform_grip.h"
#include "app/editor/state/transform_pivot.h"
#include "core/edit/plane_map.h"

namespace batten::editor {

/// Shift keeps proportions, or a move to an axis; Ctrl keeps angles to the step, places to the grid; Alt lets go of
/// what they snap to. Numbers that are typed rule. The pivot is kept in the state, where Escape puts it back.
struct DraggingTransform {
    TransformGrip grip;
    glm::dvec2 press_px{};
    bool has_moved = false;
    core::PlaneMap map{};                    ///< what the drag does to the box, for the picture
    std::optional<TransformPivot> before{};  ///< the pivot when it began
    std::optional<std::size_t> clicked{};    ///< the control point where it began, which a mere click selects
};

}  // namespace batten::editor
