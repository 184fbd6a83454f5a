/// What the pointer does on a picture.
#pragma once

#include <glm/vec2.hpp>

#include "app/editor/state/key.h"

namespace batten::editor {

/// `finish` and `take_back` are keys that a drawing listens to: Enter, and Backspace or Ctrl+Z.
enum class PointerAction { move, press, release, double_click, wheel, leave, escape, finish, take_back, key };
enum class PointerButton { none, left, middle, right };

/// One event, in pixels of the picture (x right, y down). A move is sent whenever position or modifiers changed. A
/// double click comes instead of the second press. Escape is sent as an event of its own, so that a gesture can be
/// given up; so are keys and characters that a gesture may be about.
struct PointerEvent {
    PointerAction action = PointerAction::move;
    glm::dvec2 position_px{};
    PointerButton button = PointerButton::none;
    Modifiers modifiers;
    bool space_is_held = false;
    double wheel = 0.0;           ///< notches, positive away from the user
    double sideways_wheel = 0.0;  ///< notches, positive to the left
    Key key = Key::none;          ///< of PointerAction::key, where it is no character
    char32_t character = 0;       ///< that was typed, else 0
};

}  // namespace batten::editor
