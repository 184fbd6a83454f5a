/// What a frame of the interface gets from the window, and where it put things.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "app/editor/pointer/cursor.h"
#include "app/editor/pointer/pointer.h"
#include "app/editor/state/key.h"

namespace batten::ui {

/// A rectangle of the window, in window pixels from the upper left corner.
struct Rectangle {
    glm::dvec2 origin_px{};
    glm::dvec2 size_px{};

    bool contains(glm::dvec2 p) const {
        return origin_px.x <= p.x && p.x < origin_px.x + size_px.x && origin_px.y <= p.y &&
               p.y < origin_px.y + size_px.y;
    }
};

/// A key that went down (or repeats), or the character that it typed.
struct KeyPress {
    editor::Shortcut shortcut;
    editor::Shortcut printed{};  ///< the sign that the key prints with its modifiers, where there is one
    char32_t character = 0;      ///< not 0: this is a character of typed text, and no key
};

/// What happened since the last frame, in order. Positions of pointer events are window pixels.
struct FrameInput {
    std::vector<editor::PointerEvent> pointer_events;
    std::vector<KeyPress> key_presses;
    double frames_per_second = 0.0;  ///< of the last second in which something moved; shown in the status bar
};

/// A widget's place and what it shows, so that a program that drives the window can find it.
struct WidgetPlace {
    std::string name;  ///< "point 5 w", "menu file", "button insert-knot"
    Rectangle place;
    std::string value;
};

/// Where the interface put the pictures, which are painted below it.
struct FrameLayout {
    Rectangle canvas;
    Rectangle rulers;  ///< around the canvas, whose pointer events theirs are; of no size while they are hidden
    Rectangle plot;    ///< of no height when the dock is folded away
    std::vector<WidgetPlace> widgets;
    editor::Cursor cursor = editor::Cursor::arrow;
};

}  // namespace batten::ui
