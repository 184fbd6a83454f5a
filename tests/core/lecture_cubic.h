/// The curve of a lecture on knot insertion.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// Clamped and uniform over [0, 1], of which lectures show what an insertion at 1/2 makes.
inline Curve lecture_cubic() {
    return Curve::make({.degree = 3,
                        .knots = {0, 0, 0, 0, 0.2, 0.4, 0.6, 0.8, 1, 1, 1, 1},
                        .points = {{0, 0}, {0, 6}, {6, 6}, {6, 0}, {12, 0}, {12, 6}, {18, 6}, {18, 0}}})
        .value();
}

}  // namespace batten::core
