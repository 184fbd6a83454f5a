/// How much of a document's coordinates one unit may be.
#pragma once

#include "core/base/geometry.h"

namespace batten::core {

/// Beyond it, lengths that can be drawn are no numbers any more, or have no digits left.
inline constexpr Interval allowed_unit_scales{1e-9, 1e9};

}  // namespace batten::core
