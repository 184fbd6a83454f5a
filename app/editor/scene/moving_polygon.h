/// The control polygon while a knot comes in: corners that are cut off go to the new points.
#pragma once

#include "app/editor/derived/cut_polygon.h"
#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// What of it is drawn.
struct MovingParts {
    bool polygon = false;
    bool points = false;
    bool names = false;
};

/// Draws `moving` over the picture in `list`, which has the curve of `frame`, with the knot in it, without its control
/// points. In the first half of the way corners are called as before, both parts of one alike, in the second half as
/// after it; names that change fade out and in between. The names stay off what is drawn, and those without room are
/// noted as unplaced.
void draw_moving_polygon(CanvasFrame& frame, const render::DrawList& list, MovingPolygon moving,
                         const MovingParts& parts);

}  // namespace batten::editor
