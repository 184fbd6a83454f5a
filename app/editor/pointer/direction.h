/// Directions and their angles, to the last bit where these are the usual ones.
#pragma once

#include "core/base/geometry.h"

namespace batten::editor {

/// The direction of `way` in degrees, from -180 to 180; exact along the axes and between them, 0 of no way at all.
double degrees_of(core::Vector way);

/// (cos, sin), exact at quarters of a turn, and 1/2 where that is the sine or cosine.
core::Vector direction_of(double degrees);

/// The direction of a way that is not 0: where it is that of whole degrees but for rounding, direction_of these.
core::Vector direction_of(core::Vector way);

}  // namespace batten::editor
