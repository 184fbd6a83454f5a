/// The convex hulls of all spans.
#pragma once

#include "app/editor/scene/canvas_frame.h"
#include "app/editor/scene/crowd.h"

namespace batten::editor {

/// The hull of the p+1 control points of each span in the picture, in the colors of the construction by turns; of very
/// many spans some. Returns of how many.
Thinned draw_span_hulls(CanvasFrame& frame);

}  // namespace batten::editor
