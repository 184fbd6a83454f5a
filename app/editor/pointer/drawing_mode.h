/// The mode in which a curve is drawn click by click.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "core/base/geometry.h"

namespace batten::editor {

/// What the pen's mode (View::pen_mode) makes a curve of. Enter, a double click, a right click, or a click on the last
/// point end it; one on the first point closes it; Backspace and Ctrl+Z take back the last point. The wheel, the middle
/// button and Space move the view meanwhile. Escape gives it up with its tool; taking another tool ends it, too.
struct DrawingCurve {
    std::vector<core::Point> points;
    core::Point next{};
    std::size_t tool_changes = 0;           ///< of the state when it began
    std::vector<core::Vector> handles{};    ///< in Bézier mode, of the first points; zero for a corner
    std::optional<glm::dvec2> pulled_px{};  ///< where the press was whose handle is being drawn out
    /// The handle that is being drawn out is that of the first point, which had this one; the release closes the curve.
    std::optional<core::Vector> first_handle{};
    std::optional<glm::dvec2> panned_px{};  ///< where the pointer was while the view is being moved
    bool closes = false;                    ///< the pointer is where a click closes the curve
};

}  // namespace batten::editor
