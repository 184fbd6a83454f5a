/// The stroke of a pencil from which the last step of the history came, so that it can be fitted anew.
#pragma once

#include <memory>
#include <vector>

#include "core/base/geometry.h"

namespace batten::editor {

struct DrawnStroke {
    std::shared_ptr<const std::vector<core::Point>> points;
    double pixel = 1.0;     ///< how large a pixel was
    int smoothness = 0;     ///< with which it was fitted last
    std::size_t curve = 0;  ///< the index of the curve that came of it
    bool redraws = false;   ///< whether it replaced a part of that curve
    std::size_t step = 0;   ///< History::undo_count() after it
};

}  // namespace batten::editor
