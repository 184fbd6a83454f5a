/// The handlebar that holds the active curve at a parameter.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Its middle, and its arms with a ring at each tip; nothing where none is shown.
void draw_handlebar(CanvasFrame& frame);

}  // namespace batten::editor
