/// The control polygons that the pieces of the active curve have as Bézier curves.
#pragma once

#include "app/editor/scene/crowd.h"

namespace batten::editor {

/// For each span in the picture the polygon of its piece; where they are too many, for some of them. Returns how many
/// of how many.
Thinned draw_bezier_pieces(CanvasFrame& frame);

}  // namespace batten::editor
