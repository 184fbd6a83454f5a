/// Two points of a picture that are clicked before their distance is typed, which scales the picture.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/geometry.h"

namespace batten::editor {

struct EditorState;

struct PictureGauge {
    std::size_t picture = 0;          ///< in the document
    std::vector<core::Point> points;  ///< clicked so far; with two of them the length is asked for
};

/// Whether clicks choose points of a picture now.
bool is_gauging(const EditorState& state);

/// Takes a click at `point`; the second one opens the form for the length.
void add_gauge_point(EditorState& state, core::Point point);

}  // namespace batten::editor
