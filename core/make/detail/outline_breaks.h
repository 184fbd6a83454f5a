/// Where an outline has corners and straight stretches.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/make/contours.h"

namespace batten::core {

/// A place of a contour at which its pieces meet.
struct OutlineBreak {
    Point point{0.0, 0.0};
    std::size_t index = 0;              ///< of the contour's point there
    bool is_corner = true;              ///< else a straight stretch begins or ends there smoothly
    bool begins_line = false;           ///< what follows, up to the next break, is straight
    std::optional<Vector> direction{};  ///< of unit length, along the straight stretch where it is no corner
};

/// The breaks of a contour that is accurate to about a tenth of its unit, in order; none where it is smooth all around.
/// A corner is a vertex of the polygon within 0.3 of the contour that turns more, over its shorter side, than a bend of
/// any radius would. Cost O(n log n) for most contours.
std::vector<OutlineBreak> breaks_of(const Contour& contour);

}  // namespace batten::core
