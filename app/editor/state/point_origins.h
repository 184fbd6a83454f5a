/// Which control points of a curve came of which ones of the curve before an edit.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/curve/curve.h"

namespace batten::editor {

/// For each control point of a curve its older one, ascending; none for a new point.
using PointOrigins = std::vector<std::optional<std::size_t>>;

/// The origins of the points of `after`, which came of `before` and has another number of them: those at both ends that
/// stayed in place; in between each point goes to the nearest one by Greville abscissae, so that a point which a knot
/// has drawn along its leg is that of its old place. Cost O(n p).
PointOrigins point_origins(const core::Curve& before, const core::Curve& after);

}  // namespace batten::editor
