/// What the canvas shows, as a picture.
#pragma once

#include "app/editor/canvas_mode.h"
#include "app/editor/state.h"
#include "render/draw_list.h"

namespace batten::editor {

/// The document as seen through the view's camera: grid, ghost, curves, polygon, hull, knots, construction, points,
/// labels, box selection. Sizes follow the view's interface scale.
render::DrawList canvas_scene(const EditorState& state, const CanvasMode& mode);

}  // namespace batten::editor
