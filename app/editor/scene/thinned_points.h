/// Control points so far apart on the screen that a hand can tell them from each other.
#pragma once

#include <span>
#include <vector>

#include "app/editor/scene/crowd.h"

namespace batten::editor {

/// How far apart the drawing mode keeps control points, in design pixels.
inline constexpr double drawing_gap = 6.0;

/// Of `count` (> 0) indices from `first` on the one that stays longest while they are thinned: it is divided by the
/// highest power of two.
std::size_t lasting_index(std::size_t first, std::size_t count);

/// Those of `places` that no other one that lasts longer is nearer to than `gap_px` (> 0): no two of them are nearer to
/// each other. Which stay depends on the places around them only, not on what is seen, so that they do while the view
/// moves; `origin_px` is where the world's (0, 0) is. In the order of the places. Cost O(n).
std::vector<MarkPlace> thinned(const std::vector<MarkPlace>& places, double gap_px, glm::dvec2 origin_px);

/// The selected control points that are seen whatever is thinned: all, unless they are more than a hand picks.
std::span<const std::size_t> picked_points(const Selection& selection);

}  // namespace batten::editor
