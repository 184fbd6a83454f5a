/// Dots that divide the curve into parts of equal parameter or equal length.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Full dots at equal steps of u; rings at equal lengths, which fit around the dots.
void draw_equal_steps(CanvasFrame& frame);
void draw_equal_lengths(CanvasFrame& frame);

}  // namespace batten::editor
