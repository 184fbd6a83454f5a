/// A box in the canvas for what is told beside the picture: legend and inset.
#pragma once

#include "app/editor/scene/pen.h"
#include "app/editor/state/theme.h"

namespace batten::editor {

/// Fills `box` like a panel, with a border and rounded corners.
void draw_panel_box(Pen& pen, const Theme& theme, const render::PixelBox& box);

}  // namespace batten::editor
