/// The control points whose support is shown.
#pragma once

#include <vector>

#include "app/editor/state/state.h"

namespace batten::editor {

/// At most so many at a time.
inline constexpr std::size_t most_supports = 6;

/// The selected control points of the shown active curve, the first few of them; without any the hovered one, also by
/// its basis function or its ring.
std::vector<std::size_t> points_with_support(const EditorState& state);

}  // namespace batten::editor
