/// All that is selected, over several curves, dragged.
#pragma once

#include <glm/vec2.hpp>

#include "app/editor/state/selection.h"
#include "core/base/geometry.h"

namespace batten::editor {

/// What is selected follows the pointer, as one step. Ctrl snaps what was grabbed to the grid, Shift keeps to one axis.
struct DraggingSelection {
    core::Point start{};     ///< where what was grabbed lay
    SelectedPart grabbed{};  ///< a point or a curve; a mere click is about it
    glm::dvec2 press_px{};
    bool was_selected = false;  ///< before the press; a mere click with Shift then takes it out
    bool has_moved = false;
};

}  // namespace batten::editor
