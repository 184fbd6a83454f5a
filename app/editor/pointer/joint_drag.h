/// Fillets, chamfers and offsets whose size is dragged with the joint tool.
#pragma once

#include "app/editor/pointer/gesture.h"
#include "app/editor/pointer/joint_mode.h"

namespace batten::editor {

/// What a press on `place` would drag out: of a corner of the curve, or of an end where another curve ends too, the
/// radius or the distances; of any place an offset. None for other operations, and away from corners. `place` is put
/// where the corner is.
std::optional<JointDrag> begin_joint_drag(const Gesture& gesture, PickedCurvePlace& place);

/// The same drag where the pointer is now: of an offset the distance of that place from the curve, above 0 on its left;
/// else that from the corner. What is typed for the place rules.
JointDrag dragged_joint(const Gesture& gesture, const PickedCurvePlace& place, JointDrag drag);

/// "Radius 5 mm" of a fillet, "Distance 5 mm" of the others, in the document's unit.
std::string size_words(const EditorState& state, const JointDrag& drag);

/// What the drag does; its curve is active.
Command command_of_drag(const EditorState& state, const PickedCurvePlace& place, const JointDrag& drag);

}  // namespace batten::editor
