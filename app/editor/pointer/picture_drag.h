/// Pictures under the pointer, dragged where they are not locked.
#pragma once

#include <optional>

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/gesture.h"

namespace batten::editor {

CanvasMode step(const DraggingPicture& mode, const Gesture& gesture);

/// The topmost picture at a pixel of the canvas that can be dragged: seen and not locked.
std::optional<std::size_t> picture_at(const EditorState& state, glm::dvec2 position_px);

}  // namespace batten::editor
