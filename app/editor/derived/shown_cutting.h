/// Which insertion of a knot the views of corner cutting show, and in which colors.
#pragma once

#include <vector>

#include "app/editor/command_spec.h"
#include "app/editor/state/state.h"
#include "core/refine/corner_cutting.h"

namespace batten::editor {

/// The last insertion, found anew in the shown curve so that it follows while the curve is dragged; once the parameter
/// was moved, the one that inserting u would be.
struct ShownCutting {
    core::CornerCutting cutting;
    bool has_happened = false;  ///< the shown curve is the one after it; else the one before
    double deviation = 0.0;     ///< of one that has happened: how far the older curve is from the shown one
    std::vector<std::size_t> corner_hues{};  ///< for Theme::point(), of cutting.corners
    std::vector<std::size_t> cut_hues{};     ///< of cutting.cuts; those that the points have or would have afterward
};

/// That of the shown active curve, or why there is none, as a sentence. Cost O(p^3), whatever the number of points.
Outcome<ShownCutting> shown_cutting(const EditorState& state);

}  // namespace batten::editor
