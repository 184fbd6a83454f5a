/// The control polygon while a knot comes in: corners that are cut off go to the new points.
#pragma once

#include <span>

#include "app/editor/derived/cut_polygon.h"
#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// What of it is drawn.
struct MovingParts {
    bool polygon = false;
    bool points = false;
    bool names = false;
};

/// Draws `corners` over the picture in `list`, which has the curve of `frame` without its control points. Both parts of
/// a corner have its name; the names stay off what is drawn, and those without room are noted as unplaced.
void draw_moving_polygon(CanvasFrame& frame, const render::DrawList& list, std::span<const CutCorner> corners,
                         const MovingParts& parts);

}  // namespace batten::editor
