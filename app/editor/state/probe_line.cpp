#include "app/editor/state/probe_line.h"

#include <algorithm>
#include <cmath>

#include "core/curve/control_box.h"

namespace batten::editor {

ProbeLine level_line_through(const core::Curve& curve) {
    const core::Box box = core::control_box(curve);
    const core::Vector half = 0.5 * core::vector_to(box.upper) - 0.5 * core::vector_to(box.lower);
    const core::Point middle = core::middle(box.lower, box.upper);
    const double larger = std::max(half.x, half.y);
    double reach = 0.8 * (half.x > 0.0 ? half.x : larger);
    if (!(reach > 0.0)) reach = std::max(1.0, std::abs(middle.x));
    const ProbeLine line{middle - core::Vector(reach, 0.0), middle + core::Vector(reach, 0.0)};
    return is_line(line) ? line : ProbeLine{{0.0, 0.0}, {1.0, 0.0}};
}

bool is_line(const ProbeLine& line) {
    // The plain length, as everything that is computed along the line squares its coordinates.
    const double length = core::length(line.second - line.first);
    return core::is_finite(line.first) && core::is_finite(line.second) && length > 0.0 && std::isfinite(length);
}

}  // namespace batten::editor
