/// A shape drawn place by place with the shape tool.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "app/editor/state/shape_kind.h"
#include "core/base/geometry.h"

namespace batten::editor {

/// Each click, or each typed place, is one of the places that make the shape; the last one makes it. Backspace and
/// Ctrl+Z take back the last one. Escape gives it up, and so do a right click and a change of the tool.
struct DrawingShape {
    ShapeKind kind = ShapeKind::line;
    std::vector<core::Point> points;  ///< so far, at least one
    core::Point next{};
    double turned = 0.0;           ///< radians that the pointer went around the first place since the second one
    std::size_t tool_changes = 0;  ///< of the state when it began
    std::optional<glm::dvec2> panned_px{};  ///< where the pointer was while the view is being moved
};

}  // namespace batten::editor
