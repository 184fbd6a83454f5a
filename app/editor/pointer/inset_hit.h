/// What of the pictures in boxes over the canvas is under the pointer.
#pragma once

#include "app/editor/scene/insets.h"

namespace batten::editor {

/// What lies under `position_px` in `inset`: of a hodograph its control points (within 7 design pixels) as far as each
/// is made by points of the curve, then the curve (6), of one with few hundred control points; of the lifted curve
/// control points (10), then the curve or its shadow (6). Else the inset itself. Cost bounded for any curve.
Hover hit_inset(const EditorState& state, const InsetPlace& inset, glm::dvec2 position_px);

}  // namespace batten::editor
