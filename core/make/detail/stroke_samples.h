/// What a pen left behind, in pixels and along its way.
#pragma once

#include <span>
#include <vector>

#include "core/make/detail/penalized_spline.h"

namespace batten::core {

struct Stroke {
    std::vector<StrokeSample> samples{};  ///< by their stations; places are seen from the first point, in pixels
    double length = 0.0;                  ///< of the way, and back to its beginning where it is closed
    bool is_closed = false;
};

/// The stroke through `points`, finite, of which there is one at least, with a pixel of the size `pixel`. Where the pen
/// rests or crawls the noise of the hand is not taken for a way. It is closed where it comes back to its beginning and
/// `may_close`; what it then overshoots is left out. Cost O(m).
Stroke stroke_through(std::span<const Point> points, double pixel, bool may_close);

}  // namespace batten::core
