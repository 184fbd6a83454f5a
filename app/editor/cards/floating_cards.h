/// Where cards lie on the canvas for a projector, until they are moved.
#pragma once

#include <optional>

#include "app/editor/state/state.h"
#include "render/pixel_box.h"

namespace batten::editor {

/// At the right edge of the canvas and as high as it, in its pixels; none where there are no cards or no projector.
std::optional<render::PixelBox> floating_cards_box(const EditorState& state);

}  // namespace batten::editor
