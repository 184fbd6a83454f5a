/// A curve that stands for another one, and how far from it it really is.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

struct Approximation {
    Curve curve;
    double error =
        0.0;  ///< the largest distance found between the two, in the units of the points; measured, not estimated
};

}  // namespace batten::core
