/// Runs a command on a state: checks it, and makes its edit a step of the history or does its act.
#pragma once

#include <vector>

#include "app/editor/command.h"
#include "app/editor/state/state.h"
#include "core/base/sentence.h"

namespace batten::editor {

/// What Editor::run says, but on any state and always at once. Returns whether the command did what it was asked for;
/// the message tells why not.
bool run_checked(EditorState& state, const Command& command, Phase phase);

/// Places named after the fields of `command`, for its texts.
std::vector<core::Place> places_of(const Command& command, const EditorState& state);

}  // namespace batten::editor
