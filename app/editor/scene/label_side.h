/// On which side of a mark its label is tried first.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <numbers>

#include "app/editor/scene/label_layout.h"

namespace batten::editor {

/// The side of a mark to which `direction` (pixels, y down) points most.
inline LabelSide side_toward(glm::dvec2 direction) {
    constexpr std::array around{LabelSide::right, LabelSide::lower_right, LabelSide::below, LabelSide::lower_left,
                                LabelSide::left,  LabelSide::upper_left,  LabelSide::above, LabelSide::upper_right};
    const double eighths = std::atan2(direction.y, direction.x) / (0.25 * std::numbers::pi);
    return std::isfinite(eighths) ? around.at(static_cast<std::size_t>(std::lround(eighths) + 8) % around.size())
                                  : LabelSide::upper_right;
}

}  // namespace batten::editor
