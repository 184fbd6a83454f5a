/// What the colors of the construction mean.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Where the legend is; the frame must have a curve.
render::PixelBox legend_box(const CanvasFrame& frame);

/// "de Boor ● level 1 ● level 2 ● level 3", with all levels of one color together.
void draw_legend(CanvasFrame& frame);

}  // namespace batten::editor
