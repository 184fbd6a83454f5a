/// The canvas while a file is opened: what is read of it so far.
#pragma once

#include "app/editor/state/state.h"
#include "render/draw_list.h"

namespace batten::editor {

/// Whether anything is read that can be shown.
bool has_sketch(const EditorState& state);

/// The points of the sketch, as large as the canvas allows, whatever the view's camera shows.
render::DrawList sketch_scene(const EditorState& state);

}  // namespace batten::editor
