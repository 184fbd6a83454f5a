/// Marks at the places that a measuring command found.
#pragma once

#include <vector>

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// What labels must keep clear of: the marks and their numbers, unless there are too many to be numbered.
std::vector<render::PixelBox> finding_boxes(const CanvasFrame& frame);

/// A square at each point of the findings, with its number in the list, counted from 1. Nothing while a gesture shows
/// another shape.
void draw_finding_marks(CanvasFrame& frame);

}  // namespace batten::editor
