/// What the canvas shows, as a picture.
#pragma once

#include "app/editor/derived/cut_polygon.h"
#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/scene/scene_cache.h"
#include "app/editor/state/state.h"
#include "render/draw_list.h"

namespace batten::editor {

/// The document as seen through the view's camera: grid, ghost, curves, polygon, hull, knots, construction, points,
/// labels, box selection. Sizes follow the view's interface scale. However much there is to show, its cost is that of
/// what a picture can hold, and of what changed since the last one with the same `cache`. While a
/// file is opened, what is read of it stands there instead.
render::DrawList canvas_scene(const EditorState& state, const CanvasMode& mode, SceneCache& cache);

/// The same at rest with `moving` for its control polygon: the line, and of the points those too dense for their size.
/// The others lie above it, and the caller draws them; what stands beside them makes way as before.
render::DrawList canvas_scene_around(const MovingPolygon& moving, const EditorState& state, SceneCache& cache);

}  // namespace batten::editor
