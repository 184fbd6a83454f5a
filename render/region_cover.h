/// How much of each pixel lies inside loops that may cross themselves and each other.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "render/coverage_map.h"

namespace batten::render {

/// Inside where a loop runs round an odd number of times, or any number but 0, those to the left less those to the
/// right.
enum class FillRule { even_odd, non_zero };

/// Closed polygons in pixels, which together enclose a region.
struct RegionLoops {
    std::vector<std::vector<glm::vec2>> loops;
    FillRule rule = FillRule::non_zero;
};

/// The share of each pixel that is inside, seen along four lines through it. Cost: the rows that each segment crosses
/// in the picture, and the pixels inside.
CoverageMap region_coverage(const RegionLoops& region, glm::ivec2 size_px);

}  // namespace batten::render
