/// What of the transform box can be dragged.
#pragma once

namespace batten::editor {

enum class GripKind {
    inside,  ///< moves what is in the box
    scale,   ///< a corner, or the middle of a side
    turn,    ///< beyond a corner
    shear,   ///< a side
    pivot
};

/// A grip of the box: `x` and `y` lead from its middle to the grip, each -1, 0 or 1 (y upward).
struct TransformGrip {
    GripKind kind = GripKind::inside;
    int x = 0;
    int y = 0;
    bool operator==(const TransformGrip&) const = default;
};

}  // namespace batten::editor
