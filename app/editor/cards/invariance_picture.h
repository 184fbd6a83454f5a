/// The picture that maps polygon and curve side by side.
#pragma once

#include <memory>

#include "app/editor/cards/card.h"
#include "app/editor/derived/map_check.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// On the left the curve and the images of its points, on the right the control polygon, its image, and the curve of
/// that; both at one scale, with the point at u. `check`, which has an image, is that of `mapped`.
CardPicture invariance_picture(const EditorState& state, const MappedCurve& mapped,
                               std::shared_ptr<const MapCheck> check);

}  // namespace batten::editor
