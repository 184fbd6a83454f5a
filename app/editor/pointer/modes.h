/// How modes with sources of their own begin and go on.
#pragma once

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/gesture.h"

namespace batten::editor {

/// The mode after an event, whichever it is in.
CanvasMode step_mode(const CanvasMode& mode, const Gesture& gesture);

CanvasMode step(const DoubleClicking& mode, const Gesture& gesture);

/// Whether the pointer is where the tool acts: over no ruler and inset, while no axis and no gauge is clicked.
bool is_about_tool(const Gesture& gesture);

/// Zooms or pans as the wheel is turned.
void turn_canvas_wheel(const Gesture& gesture);

CanvasMode begin_guide_drag(const Gesture& gesture, std::size_t index);
CanvasMode step(const DraggingGuide& mode, const Gesture& gesture);

/// Of a handlebar that is shown; nothing begins where the curve is locked.
CanvasMode begin_handlebar_drag(const Gesture& gesture, HandlebarPart part);
CanvasMode step(const DraggingHandlebar& mode, const Gesture& gesture);

/// Drags a guide out of a ruler; where both meet the form for the unit opens.
CanvasMode begin_ruler_gesture(const Gesture& gesture);
CanvasMode step(const PullingGuide& mode, const Gesture& gesture);

/// The shape tool's first place.
CanvasMode begin_shape(const Gesture& gesture);
CanvasMode step(DrawingShape mode, const Gesture& gesture);

/// The brush, from the first move over the canvas on.
CanvasMode begin_brush(const Gesture& gesture);
CanvasMode step(const Brushing& mode, const Gesture& gesture);

/// The joint tool, from the first move over the canvas on.
CanvasMode begin_joint(const Gesture& gesture);
CanvasMode step(PickingJoint mode, const Gesture& gesture);

/// Forgets places of curves that an edit has changed or taken away since they were picked.
void drop_gone_places(PickingJoint& mode, const EditorState& state);

/// How many notches the brush grows by the key of a bracket; none for other keys.
std::optional<double> brush_notches_of_key(const PointerEvent& event);

/// A drag of the transform box, which began on a control point or on none.
CanvasMode begin_transform(const Gesture& gesture, TransformGrip grip,
                           std::optional<std::size_t> clicked = std::nullopt);
CanvasMode step(DraggingTransform mode, const Gesture& gesture);

/// The continuity that the digit of a key stands for; none for other keys.
std::optional<core::GeometricContinuity> continuity_of_key(const PointerEvent& event);

}  // namespace batten::editor
