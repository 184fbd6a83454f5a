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
/// unit, binary fractions of inches. No two labels touch. No more than two for three design pixels.
std::vector<RulerTick> ruler_ticks(const EditorState& state, RulerAxis axis);

/// "1.5", "−20"; inches as "2 3/4". `value` is a multiple of `step` (> 0), in the document's unit.
std::string ruler_number(double value, double step, const Units& units);

/// What stands where the rulers meet: "mm", "in", "px", or nothing.
std::string ruler_corner(const EditorState& state);

/// The ruler that a place of the canvas, which begins behind the rulers, is on; none elsewhere, or while they are
/// hidden.
std::optional<RulerAxis> ruler_at(const EditorState& state, glm::dvec2 position_px);

/// Whether that is where they meet.
bool is_in_ruler_corner(const EditorState& state, glm::dvec2 position_px);

}  // namespace batten::editor
