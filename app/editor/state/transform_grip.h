/// What of the transform box can be dragged, and its pivot.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/geometry.h"

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

/// A point that was chosen to stay while what is selected is scaled, turned or sheared; it counts while that stays
/// selected.
struct TransformPivot {
    core::Point point{};
    std::size_t curve = 0;                ///< the active one, in the document
    std::vector<std::size_t> selected{};  ///< the control points
    bool operator==(const TransformPivot&) const = default;
};

}  // namespace batten::editor
