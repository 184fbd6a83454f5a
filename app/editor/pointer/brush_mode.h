/// The mode of the brush, from the first move over the canvas on.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "core/base/geometry.h"

namespace batten::editor {

/// A control point within the brush, and the share of the move that it takes.
struct HeldPoint {
    std::size_t index = 0;
    double share = 0.0;
};

/// A brush over the canvas. With soft move a press holds a place, which the points around it follow; with fairing it
/// marks what it paints over. Escape gives up the press, then the tool.
struct Brushing {
    glm::dvec2 position_px{};
    std::optional<glm::dvec2> press_px{};
    core::Point center{};                     ///< of a soft move: the place that is held, or would be
    std::vector<HeldPoint> held{};            ///< and what it takes along
    std::optional<core::Interval> painted{};  ///< of the committed curve; a periodic one may go on beyond its domain
    bool has_moved = false;
    std::size_t tool_changes = 0;  ///< of the state when it began
};

}  // namespace batten::editor
