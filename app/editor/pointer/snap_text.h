/// What is said of what the pointer snaps to.
#pragma once

#include <optional>

#include "app/editor/state/placing.h"
#include "core/document/document.h"

namespace batten::editor {

/// Something to snap to, before it has a text.
struct SnapFound {
    SnapKind kind = SnapKind::grid;
    core::Point position{};
    std::size_t thing = 0;               ///< the curve in the document, or the guide
    std::size_t index = 0;               ///< of the control point, the leg, or the other guide
    double number = 0.0;                 ///< the parameter, or the direction in degrees
    std::size_t other = 0;               ///< the curve that crosses, or the point at the other end of the leg
    bool is_crossing = false;            ///< of guides
    std::optional<std::size_t> guide{};  ///< that crosses the curve
    std::vector<SnapLine> lines{};
};

/// With its label and its sentence; `document` is the one it was found in.
Snap snap_of(const core::Document& document, const SnapFound& found);

}  // namespace batten::editor
