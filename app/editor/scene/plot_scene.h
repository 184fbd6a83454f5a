/// What the dock shows, as a picture: basis functions above, knot strip below, on one u axis.
#pragma once

#include "app/editor/pointer/plot_layout.h"
#include "app/editor/pointer/plot_mode.h"
#include "app/editor/scene/scene_cache.h"
#include "app/editor/state/state.h"
#include "render/draw_list.h"

namespace batten::editor {

/// The basis functions and knots of the shown active curve in a picture of `size_px`.
render::DrawList plot_scene(const EditorState& state, const PlotMode& mode, glm::dvec2 size_px, SceneCache& cache);

}  // namespace batten::editor
