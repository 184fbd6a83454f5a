/// What stands on the rulers along the upper and the left edge of the canvas.
#pragma once

#include <string>
#include <vector>

#include "app/editor/state/state.h"
#include "app/editor/words/length.h"

namespace batten::editor {

/// How wide the rulers are, in design pixels.
inline constexpr double ruler_width = 20.0;

struct RulerTick {
    double place_px = 0.0;  ///< from the left or the upper edge of the canvas
    double length = 0.0;    ///< a share of the ruler's width
    std::string label;      ///< behind the tick; empty on most
};

/// The ticks that are seen, of the canvas's grid and between its lines: 1, 2 or 5 times powers of ten of the document's
/// unit, binary fractions of inches. Labels are whole and do not touch; where the ruler is 300 design pixels long or
/// more and its numbers have up to six digits, there are at least three. No more than two ticks for three design
/// pixels.
std::vector<RulerTick> ruler_ticks(const EditorState& state, RulerAxis axis);

/// What stands where the rulers meet: "mm", "in", "px", or nothing.
std::string ruler_corner(const EditorState& state);

/// The ruler that a place of the canvas, which begins behind the rulers, is on; none elsewhere, or while they are
/// hidden.
std::optional<RulerAxis> ruler_at(const EditorState& state, glm::dvec2 position_px);

/// Whether that is where they meet.
bool is_in_ruler_corner(const EditorState& state, glm::dvec2 position_px);

}  // namespace batten::editor
