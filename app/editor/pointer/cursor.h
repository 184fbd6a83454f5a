/// The shape of the pointer that says what a press would do.
#pragma once

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/plot_mode.h"
#include "core/base/names.h"

namespace batten::editor {

enum class Cursor {
    arrow,
    hand,        ///< something can be dragged along the curve
    move,        ///< something follows the pointer, or the picture does
    crosshair,   ///< a place is chosen
    horizontal,  ///< something moves to the left and right
    vertical,    ///< something grows upward and shrinks downward
    text
};

/// Over the canvas: of the gesture under way, else of the tool and what is hovered.
Cursor canvas_cursor(const CanvasMode& mode, const EditorState& state, bool space_is_held);

/// Over the plot and the knot strip.
Cursor plot_cursor(const PlotMode& mode, const EditorState& state, bool space_is_held);

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::Cursor> {
    using enum editor::Cursor;
    static constexpr std::array table{Named{arrow, "arrow", ""},
                                      Named{hand, "hand", ""},
                                      Named{move, "move", ""},
                                      Named{crosshair, "crosshair", ""},
                                      Named{horizontal, "horizontal", ""},
                                      Named{vertical, "vertical", ""},
                                      Named{text, "text", ""}};
};

}  // namespace batten::core
