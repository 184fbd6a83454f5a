/// Sines and cosines of angles in degrees, exact where a quarter or an eighth of a turn is.
#pragma once

#include "core/base/geometry.h"

namespace batten::core {

/// (cos, sin) of `degrees`; not a number where that is not finite. At multiples of 90 exactly 0 and 1, at those of 30
/// exactly 1/2 where it should be, and mirrored angles have mirrored results, to the last bit.
Vector unit_vector(double degrees);

}  // namespace batten::core
