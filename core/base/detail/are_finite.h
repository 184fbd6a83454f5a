/// Whether the coordinates of many points are numbers.
#pragma once

#include <span>

#include "core/base/geometry.h"

namespace batten::core {

/// Whether all coordinates are finite. Cost: that of reading them all, without a way out, several in one step.
bool are_finite(std::span<const Point> points);

}  // namespace batten::core
