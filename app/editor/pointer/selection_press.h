/// What presses and clicks do to a selection over several curves.
#pragma once

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/gesture.h"
#include "app/editor/state/selected_parts.h"

namespace batten::editor {

/// The mode that a press of the select tool on `hit` begins, where it is about more than the active curve: with Shift
/// another point is taken in, and what is selected already is dragged with all that is. None where it is not.
std::optional<CanvasMode> press_over_curves(const Gesture& gesture, const Hover& hit);

/// A box from here; with Shift to what is selected already, with Ctrl over all curves. `curve` is what was pressed on:
/// a mere click with Shift takes it, with its group, in or out.
CanvasMode begin_box(const Gesture& gesture, std::optional<std::size_t> curve = std::nullopt);

/// Selects what the box has, or does what a click does.
void finish_box(const BoxSelecting& mode, const Gesture& gesture);

CanvasMode step(const DraggingSelection& mode, const Gesture& gesture);

}  // namespace batten::editor
