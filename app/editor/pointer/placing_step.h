/// What all gestures that put something somewhere have in common: numbers may be typed for the place, and it is shown.
#pragma once

#include <functional>

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/gesture.h"

namespace batten::editor {

/// What a mode makes of an event.
using StepMode = std::function<CanvasMode(const CanvasMode& mode, const Gesture& gesture)>;

/// The mode after the event of `gesture`, which is offered to the typed numbers first: digits begin them, Enter takes
/// the place that they name by a press and a release, Escape drops them before it drops the gesture. Asks for what the
/// picture shows of the place.
CanvasMode step_placing(const CanvasMode& mode, const Gesture& gesture, const StepMode& step);

/// Whether a click of the tool places a point, which may be typed as well.
bool places_points(Tool tool);

/// Whether keys and characters may be about the place of a gesture, so that they are no shortcuts.
bool takes_numbers(const CanvasMode& mode, const EditorState& state);

/// Whether a key or character, an event of PointerAction::key, is for it now and so no shortcut. Keys that will type a
/// character are taken, too. Where no gesture is under way signs and letters stay shortcuts until a digit is typed.
bool takes_key(const CanvasMode& mode, const EditorState& state, const PointerEvent& event);

}  // namespace batten::editor
