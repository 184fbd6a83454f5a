/// Where the cards of views lie over the canvas for a projector.
#pragma once

#include <optional>

#include "app/editor/state/state.h"
#include "render/pixel_box.h"

namespace batten::editor {

/// Their box, at the right edge and as high as the canvas, until they are moved; none where there are none.
std::optional<render::PixelBox> floating_cards_box(const EditorState& state);

}  // namespace batten::editor
