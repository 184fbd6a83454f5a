/// The dashed ring around a control point that shows its weight and changes it when dragged.
#pragma once

#include <cstddef>
#include <optional>

#include "app/editor/state/state.h"

namespace batten::editor {

inline constexpr double greatest_ring_radius = 22.0;  ///< design pixels

/// The radius that stands for `weight` (> 0), in pixels: from 9 design pixels for a small weight, by the logarithm of 1
/// + weight, to 22 for a weight of 100 or more.
double ring_radius_px(double weight, double interface_scale);

/// The radius of the ring that is drawn for `weight`; none for a weight of 1.
std::optional<double> weight_ring_radius_px(double weight, double interface_scale);

/// The radius of the ring around point `index` of the shown active curve: also points of weight 1 have one when they
/// are selected alone or the weight tool is on, so that there is something to grab.
std::optional<double> weight_ring_radius_px(const EditorState& state, std::size_t index);

}  // namespace batten::editor
