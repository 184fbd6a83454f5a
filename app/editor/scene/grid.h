/// The adaptive grid of the canvas with the numbers of its lines.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Minor and major lines over the whole picture; minor ones fade as they come closer together.
void draw_grid(CanvasFrame& frame);

/// Numbers, in the document's unit, of the vertical lines along the lower edge, of the horizontal ones along the left
/// edge, none of them under `covered`, and none at all where a window's rulers have them. Returns where they are.
std::vector<render::PixelBox> draw_grid_numbers(CanvasFrame& frame, const std::optional<render::PixelBox>& covered);

}  // namespace batten::editor
