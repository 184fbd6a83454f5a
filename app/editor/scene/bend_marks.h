/// Marks where the curve bends in another way.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Rings at inflections, squares at extremes of the signed curvature, with their curvature where they are few. Of a
/// long curve only the spans in the picture are searched, and none while these are too many.
void draw_bend_marks(CanvasFrame& frame);

/// Whether all of `curve` is searched, not only what is seen.
bool is_searched_whole(const core::Curve& curve);

}  // namespace batten::editor
