/// Clicks that choose an axis or a center.
#pragma once

#include <optional>

#include "app/editor/command.h"
#include "app/editor/pointer/gesture.h"

namespace batten::editor {

/// The command that a click at `place` completes; none where it does not, or where both points are one.
std::optional<Command> axis_command(const EditorState& state, core::Point place);

/// Shows what a click here would make.
void hover_axis(const Gesture& gesture);

/// A click: the first point of an axis, or what completes it.
void click_axis(const Gesture& gesture);

/// Takes the first click back, or gives up where there is none.
void take_axis_click_back(const Gesture& gesture);

}  // namespace batten::editor
