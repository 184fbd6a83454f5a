/// Points that should be the same.
#pragma once

#include <gtest/gtest.h>

#include "core/base/geometry.h"

namespace batten::core {

/// In each coordinate.
inline void expect_near(Point found, Point expected, double tolerance = 1e-13) {
    EXPECT_NEAR(found.x, expected.x, tolerance);
    EXPECT_NEAR(found.y, expected.y, tolerance);
}

}  // namespace batten::core
