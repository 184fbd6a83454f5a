/// How a curve is drawn click by click, and what it is so far.
#pragma once

#include <optional>

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/gesture.h"
#include "core/curve/curve.h"

namespace batten::editor {

/// The mode after the event of `gesture`.
CanvasMode step_drawing(DrawingCurve mode, const Gesture& gesture);

/// The drawing that a press of the tool at the pointer begins.
DrawingCurve begin_drawing(const Gesture& gesture);

/// Asks for the curve through the points that were clicked, open; nothing while they are fewer than two.
void keep_drawn(const DrawingCurve& drawing, PenMode mode, CommandQueue& queue);

/// The curve as it would be if a click came now; none while it is no curve.
std::optional<core::Curve> drawn_curve(const DrawingCurve& drawing, PenMode mode);

/// Both ends of the handle of each point of the drawing that has one: behind it and ahead of it.
struct DrawnHandle {
    core::Point behind{};
    core::Point ahead{};
};
std::vector<DrawnHandle> drawn_handles(const DrawingCurve& drawing);

}  // namespace batten::editor
