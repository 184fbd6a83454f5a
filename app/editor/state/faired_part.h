/// The part of a curve that the last step of the history faired, so that it can be faired by another distance.
#pragma once

#include <cstddef>

#include "core/base/geometry.h"

namespace batten::editor {

struct FairedPart {
    core::Interval part{};
    double distance = 0.0;  ///< by which it was faired last
    std::size_t curve = 0;  ///< the index of the curve
    std::size_t step = 0;   ///< History::undo_count() after it
};

}  // namespace batten::editor
