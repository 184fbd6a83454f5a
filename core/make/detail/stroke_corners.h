/// Where a stroke turns at once.
#pragma once

#include <vector>

#include "core/make/detail/stroke_samples.h"

namespace batten::core {

/// The stations of the corners of a stroke, ascending, strictly inside it but for one at the seam of a closed one. A
/// corner is where parabolas near the samples before and behind meet at an angle, which they do not where the stroke
/// turns along an arc of ten pixels. Where samples pass beside the tip of a corner, `stroke` gets a longer way there,
/// as long as both legs are up to the tip. Cost O(m).
std::vector<double> find_corners(Stroke& stroke);

}  // namespace batten::core
