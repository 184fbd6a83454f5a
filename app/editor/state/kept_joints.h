/// Joints that are marked, and stay as they are marked through every edit.
#pragma once

#include <string>
#include <vector>

#include "app/editor/state/marked_ends.h"
#include "core/document/document.h"

namespace batten::editor {

/// Brings `after`, which an edit made of `before`, to what its marks say (core::keep_joints), with marks that follow
/// their knots: where knots are moved, and through reversal and joins. Marks without their knot or their other end are
/// dropped, and so are those of a joint that cannot be kept, or whose end was cut off, which the sentences that are
/// returned tell. Curves that are locked or made of fit points stay as they are. Cost O(n) for each curve that changed
/// or hangs together with one by marked joints, and O(1) for the others.
std::vector<std::string> keep_marked_joints(const core::Document& before, core::Document& after);

/// The same for joints of curves that have followed others as their images since, and stay as they are.
std::vector<std::string> keep_joints_of_images(const core::Document& before, core::Document& after);

}  // namespace batten::editor
