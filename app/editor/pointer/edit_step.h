/// What pointer modes that edit have in common: preview on moves, commit on release, restore on Escape.
#pragma once

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/gesture.h"

namespace batten::editor {

inline bool is_press(const Gesture& gesture) {
    return gesture.event.action == PointerAction::press || gesture.event.action == PointerAction::double_click;
}

/// Whether the event ends a drag of the left button.
inline bool is_release(const Gesture& gesture) {
    return gesture.event.action == PointerAction::release && gesture.event.button == PointerButton::left;
}

inline bool is_move(const Gesture& gesture) {
    return gesture.event.action == PointerAction::move;
}
inline bool is_escape(const Gesture& gesture) {
    return gesture.event.action == PointerAction::escape;
}

/// A drag that edits: previews on moves, commits on release, is given up by Escape. `Mode` has press_px and has_moved;
/// `ask(mode, gesture, phase)` makes the request, and `click(mode, gesture)` does what a press without movement does.
template <class Mode, class Ask, class Click>
CanvasMode step_edit(Mode mode, const Gesture& gesture, const Ask& ask, const Click& click) {
    if (is_escape(gesture)) {
        if (mode.has_moved) gesture.queue.cancel_preview();
        return CanvasIdle{};
    }
    if (!is_move(gesture) && !is_release(gesture)) return mode;
    mode.has_moved =
        mode.has_moved || is_typed(gesture) || is_drag(gesture.state, mode.press_px, gesture.event.position_px);
    if (mode.has_moved)
        ask(mode, gesture, is_release(gesture) ? Phase::commit : Phase::preview);
    else if (is_release(gesture))
        click(mode, gesture);
    if (is_release(gesture)) return CanvasIdle{};
    return mode;
}

/// Asks for `command` as the phase of the gesture wants it.
inline void request(const Gesture& gesture, Phase phase, const Command& command) {
    if (phase == Phase::commit)
        gesture.queue.run(command);
    else
        gesture.queue.preview(command);
}

}  // namespace batten::editor
