/// The sentences that tell how many points, knots, pieces and spans there are where not all of them are drawn, and why
/// lines are coarse where they are.
#pragma once

#include <string>
#include <vector>

#include "app/editor/scene/canvas_labels.h"

namespace batten::editor {

struct CrowdNote {
    std::string text;
    render::PixelBox box;
};

/// What tells how many of these marks are drawn, where not all are, as sentences for a figure that has `points`.
std::vector<std::string> thinned_texts(const CanvasFrame& frame, const CanvasMarks& marks, const ShownPoints& points);

/// Those that are needed, in a lower corner, one above the other.
std::vector<CrowdNote> crowd_notes(const CanvasFrame& frame, const CanvasMarks& marks);

/// Over what is drawn there.
void draw_crowd_notes(CanvasFrame& frame, const std::vector<CrowdNote>& notes);

}  // namespace batten::editor
