/// Pointer modes that change weights by what shows them: Farin points and the lifted curve.
#pragma once

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/gesture.h"

namespace batten::editor {

CanvasMode step(DraggingFarinPoint mode, const Gesture& gesture);
CanvasMode step(DraggingLiftedWeight mode, const Gesture& gesture);
CanvasMode step(TurningOrbit mode, const Gesture& gesture);

/// What a press in an inset begins; nothing in one that has nothing to hold.
CanvasMode begin_inset_gesture(const Gesture& gesture);

/// Enlarges what an inset shows; whether the pointer is over one.
bool turn_wheel_over_inset(const Gesture& gesture);

/// `weight` for point `index`, or while the conic is shown the weight of a parabola or circle where it is so near (4
/// percent) that it is meant: a drag that runs over them stops there a moment.
double caught_weight(const EditorState& state, std::size_t index, double weight);

}  // namespace batten::editor
