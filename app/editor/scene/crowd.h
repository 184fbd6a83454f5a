/// Marks that are too many for their place: smaller ones, then fewer.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Something to be marked, and where.
struct MarkPlace {
    std::size_t index = 0;
    glm::dvec2 place{};
};

/// Of each index below `count`, whether one of the places has it.
std::vector<bool> is_among(std::span<const MarkPlace> places, std::size_t count);

/// Which of the places are marked, and how large.
struct Crowd {
    double radius = 0.0;           ///< of the marks, in design pixels
    bool is_small = false;         ///< they are smaller than they should be
    bool is_thinned = false;       ///< there are fewer than places
    std::vector<MarkPlace> shown;  ///< in the order of the places
};

/// How much is shown of what there is.
struct Thinned {
    std::size_t shown = 0;
    std::size_t seen = 0;
};

/// How marks may be drawn.
struct MarkSizes {
    std::span<const double> radii;  ///< descending, in design pixels
    double gap_when_thinned = 2.0;  ///< between the marks that are left
    std::size_t most = 0;           ///< marks in one picture, half as many once some are left out
    bool is_thinned = false;        ///< the places are not all there are, so there are too many
};

/// All `places`, which are in the pen's reach, with the first radius where they cover one another little; else with a
/// smaller one; with the last one thinned, one place for each cell of a grid that lies still in the world. Cost: each
/// place and radius.
Crowd settle(const CanvasFrame& frame, std::vector<MarkPlace> places, const MarkSizes& sizes);

}  // namespace batten::editor
