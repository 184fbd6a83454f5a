/// How much of the curves something that lies over the canvas hides.
#pragma once

#include "app/editor/scene/scene_cache.h"
#include "app/editor/state/state.h"
#include "render/pixel_box.h"

namespace batten::editor {

/// 0 where nothing of the shown curves, control points and polygon is under `box` (pixels of the picture that `camera`
/// makes) or within a few pixels of it; else the more the worse: a control point counts four, a curve two, a leg one.
/// Cost: that of what is near the box, once `cache` has seen the curves.
int covered(const EditorState& state, const render::Camera& camera, const render::PixelBox& box, SceneCache& cache);

}  // namespace batten::editor
