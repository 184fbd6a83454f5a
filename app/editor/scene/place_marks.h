/// Guides, and what a gesture shows of the place that it is about: what it snaps to, how far it is, what is typed.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

void draw_guides(CanvasFrame& frame);

/// Over everything else of the canvas.
void draw_place(CanvasFrame& frame);

}  // namespace batten::editor
