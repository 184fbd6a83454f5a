/// Pictures below everything else, and the points of one that are clicked.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Draws the pictures that are not hidden; one whose file cannot be read as a frame with the reason in it.
void draw_pictures(CanvasFrame& frame, render::DrawList& list);

/// Draws the points by which a picture is to be scaled.
void draw_picture_gauge(CanvasFrame& frame);

}  // namespace batten::editor
