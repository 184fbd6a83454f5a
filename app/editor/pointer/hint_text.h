/// What the hints of canvas and plot share.
#pragma once

#include <string>

#include "app/editor/state/state.h"

namespace batten::editor {

/// "u = 0.4", of the shown active curve.
std::string parameter_text(const EditorState& state);

/// Why a locked curve cannot be edited.
std::string locked_sentence(const core::DocumentCurve& curve);

}  // namespace batten::editor
