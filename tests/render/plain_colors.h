/// Colors that are easily told from each other.
#pragma once

#include "render/color.h"

namespace batten::render {

inline constexpr Color red{255, 0, 0, 255};

}  // namespace batten::render
