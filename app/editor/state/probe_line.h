/// The line of the view of variation diminishing.
#pragma once

#include "core/curve/curve.h"

namespace batten::editor {

/// An infinite line through two different points.
struct ProbeLine {
    core::Point first{};
    core::Point second{};

    bool operator==(const ProbeLine&) const = default;
};

/// Where it begins: level, through the middle of the control points, whose box is a quarter wider than the line's
/// points are apart.
ProbeLine level_line_through(const core::Curve& curve);

/// Whether it can be a line: finite, of different points.
bool is_line(const ProbeLine& line);

}  // namespace batten::editor
