/// What a press or double click on the canvas begins, by tool and by what lies under the pointer.
#pragma once

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/gesture.h"

namespace batten::editor {

/// The mode that the press or double click begins; selects what is grabbed and runs what a click alone does.
CanvasMode begin_canvas_gesture(const Gesture& gesture);

/// Where the add-point tool puts a point at `position`: the index before which it is inserted so that the polygon
/// (closed when the curve is periodic) grows least.
std::size_t best_index_for(const core::Curve& curve, core::Point position);
std::size_t best_index_for(const core::FitPoints& fit, core::Point position);

}  // namespace batten::editor
