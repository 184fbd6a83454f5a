#include "app/editor/state/selection.h"

#include <algorithm>

namespace batten::editor {

bool Selection::contains_point(std::size_t i) const {
    return std::binary_search(points.begin(), points.end(), i);
}

}  // namespace batten::editor
