/// What the colors of the construction mean.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Whether there is a visible curve whose construction is shown, and a canvas high enough for both; the other functions
/// are for such states.
bool has_legend(const EditorState& state);

/// Whether it is drawn: not while it would lie over a handle, which is where every corner is taken.
bool shows_legend(const EditorState& state);

/// Where the legend is when it stands in `corner`.
render::PixelBox legend_box(const EditorState& state, Corner corner);

/// Whether the legend and the insets would lie over each other.
bool meets_inset(const EditorState& state, Corner corner);

/// The corner where the legend covers nothing of the inset and no handle, if there is one, and least of the curves. It
/// stays where it is while it covers nothing there, or little more than elsewhere.
Corner free_corner(const EditorState& state, SceneCache& cache);

/// "de Boor ● level 1 ● level 2 ● level 3", with all levels of one color together.
void draw_legend(CanvasFrame& frame);

}  // namespace batten::editor
