/// Commands that repeat curves: along a line and around a point.
#pragma once

#include <cstddef>

#include "app/editor/command.h"
#include "core/base/geometry.h"

namespace batten::editor {

struct LinearArray {
    std::size_t count;  ///< of each curve, with itself
    core::Vector step;
    static const CommandSpec& spec();
};

struct PolarArray {
    std::size_t count;  ///< of each curve, with itself
    core::Point center;
    double step;  ///< in degrees, counterclockwise
    static const CommandSpec& spec();
};

}  // namespace batten::editor
