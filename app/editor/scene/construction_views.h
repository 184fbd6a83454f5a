/// What the teaching views of the construction add to the canvas.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The control polygon over the span after u was inserted as often as levels are shown. The frame must have a curve.
void draw_inserted_polygon(CanvasFrame& frame);

/// Names of the construction's points, as far as they have marks; of very many only that of the hovered one. None while
/// blossoms name them. The frame must have a curve.
void label_construction(CanvasFrame& frame);

/// The blossoms of the control points and of the construction's points, by indices or values as the view says; of many
/// control points those of the span at u. The frame must have a curve.
void label_blossoms(CanvasFrame& frame);

}  // namespace batten::editor
