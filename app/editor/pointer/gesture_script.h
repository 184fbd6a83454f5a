/// Gestures as a program makes them, frame by frame, so that what they cost can be measured.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "app/editor/command.h"
#include "app/editor/pointer/pointer.h"
#include "app/editor/state/state.h"
#include "core/base/names.h"

namespace batten::editor {

enum class ScriptedGesture {
    drag,         ///< the control point in the middle of the active curve follows the pointer on a small circle
    drag_knot,    ///< the knot in the middle of the strip does
    insert_knot,  ///< a knot is inserted in one frame and undone in the next
    hover,        ///< the pointer goes in circles over the canvas
    pan,          ///< the canvas follows the pointer on a circle
    zoom,         ///< the wheel turns in and out again over the middle of the canvas
    play          ///< the parameter runs
};

/// Where canvas and dock are, in pixels of the window.
struct PicturePlaces {
    glm::dvec2 canvas_origin_px{};
    glm::dvec2 plot_origin_px{};
    glm::dvec2 plot_size_px{};
};

/// Where in the window the pointer begins the gesture: on what it drags, in the middle of the canvas where that is not
/// there.
glm::dvec2 start_of(ScriptedGesture gesture, const EditorState& state, const PicturePlaces& places);

/// What the user does in one frame.
struct ScriptedFrame {
    std::vector<PointerEvent> pointer_events;
    std::vector<Command> commands;
};

/// The frame with that number, from 0, of a gesture that begins at `start_px`. It comes to its place in the first
/// frame, begins in the second and goes on for ever after. Without a curve the pointer does the same, on an empty
/// canvas.
ScriptedFrame scripted_frame(ScriptedGesture gesture, std::size_t frame, glm::dvec2 start_px, const EditorState& state);

/// The frame that ends the gesture where it began, so that a drag leaves no step.
ScriptedFrame last_frame(ScriptedGesture gesture, glm::dvec2 start_px);

/// Whether the gesture is doing what it is for, after it began.
bool is_under_way(ScriptedGesture gesture, const EditorState& state);

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::ScriptedGesture> {
    using enum editor::ScriptedGesture;
    static constexpr std::array table{Named{drag, "drag", "Drag a control point"},
                                      Named{drag_knot, "drag-knot", "Drag a knot"},
                                      Named{insert_knot, "insert-knot", "Insert a knot and undo it, in turns"},
                                      Named{hover, "hover", "Move the pointer over the canvas"},
                                      Named{pan, "pan", "Pan the canvas"},
                                      Named{zoom, "zoom", "Zoom in and out"},
                                      Named{play, "play", "Play the parameter"}};
};

}  // namespace batten::core
