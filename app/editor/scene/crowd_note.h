/// The sentence that tells how many points and knots there are where not all of them are drawn.
#pragma once

#include <optional>

#include "app/editor/scene/canvas_labels.h"

namespace batten::editor {

/// Writes it into a lower corner, if it is needed. Returns what labels must keep clear of.
std::optional<render::PixelBox> draw_crowd_note(CanvasFrame& frame, const CanvasMarks& marks);

}  // namespace batten::editor
