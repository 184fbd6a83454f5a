/// The pivot of the transform box, where one was chosen.
#pragma once

#include <cstddef>

#include "app/editor/state/selection.h"
#include "core/base/geometry.h"

namespace batten::editor {

/// A point that stays while what is selected is scaled, turned or sheared; it counts while that stays selected.
struct TransformPivot {
    core::Point point{};
    std::size_t curve = 0;  ///< the active one, in the document
    Selection selected{};
    bool operator==(const TransformPivot&) const = default;
};

}  // namespace batten::editor
