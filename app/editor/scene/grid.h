/// The adaptive grid of the canvas with the numbers of its lines.
#pragma once

#include <string>

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Minor and major lines over the whole picture; minor ones fade as they come closer together.
void draw_grid(CanvasFrame& frame);

/// Numbers of the vertical lines along the lower edge, of the horizontal ones along the left edge, none of them under
/// `covered`, and none at all where the rulers have them. Returns where they are.
std::vector<render::PixelBox> draw_grid_numbers(CanvasFrame& frame, const std::optional<render::PixelBox>& covered);

/// `value`, a multiple of `step` (> 0), with as many digits as tell neighboring multiples apart.
std::string grid_number_text(double value, double step);

}  // namespace batten::editor
