/// One command for each overlay, for its shortcut and its switch, and one that hides all teaching views.
#pragma once

#include "app/editor/command.h"
#include "app/editor/state/overlay.h"

namespace batten::editor {

/// The description of the command that shows or hides `overlay`.
const CommandSpec& toggle_overlay_spec(Overlay overlay);

template <Overlay overlay>
struct ToggleOverlay {
    static const CommandSpec& spec() { return toggle_overlay_spec(overlay); }
};

/// Hides the teaching views; what the menu View has stays.
struct HideViews {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
