/// The sentences that tell how many points, knots, pieces and spans there are where not all of them are drawn.
#pragma once

#include <optional>

#include "app/editor/scene/canvas_labels.h"

namespace batten::editor {

/// Writes those that are needed into a lower corner, one above the other. Returns what labels must keep clear of.
std::optional<render::PixelBox> draw_crowd_notes(CanvasFrame& frame, const CanvasMarks& marks);

}  // namespace batten::editor
