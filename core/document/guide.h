/// A line that points are put on.
#pragma once

#include <string>

#include "core/base/geometry.h"

namespace batten::core {

/// The straight line through `point` in the direction `angle`, endless to both sides.
struct Guide {
    Point point{};
    double angle = 0.0;             ///< degrees, from 0 up to but not 180
    std::string unknown_members{};  ///< that this version does not know, as a JSON object; empty if none
    bool operator==(const Guide&) const = default;
};

}  // namespace batten::core
