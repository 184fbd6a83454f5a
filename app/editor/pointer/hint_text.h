/// What the hints of canvas and plot share.
#pragma once

#include <string>

#include "app/editor/state/state.h"

namespace batten::editor {

/// "u = 0.4", of the shown active curve.
std::string parameter_text(const EditorState& state);

/// Why a locked curve cannot be edited, and a hidden one not by what is selected, keys and pointer.
std::string locked_sentence(const core::DocumentCurve& curve);
std::string hidden_sentence(const core::DocumentCurve& curve);

}  // namespace batten::editor
