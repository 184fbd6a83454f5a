/// Blossoms as labels: by which arguments points are named.
#pragma once

#include <string>

#include "app/editor/state/notation.h"
#include "core/evaluate/blossom_labels.h"

namespace batten::editor {

/// "f(u_{3}, u_{4}, u)", by the indices of the knots. More than six arguments are told by the first, the last, and
/// "…" for those between.
std::string blossom_by_indices(const core::BlossomLabel& label);

/// "f(0, 1/4, u)", by their values.
std::string blossom_by_values(const core::BlossomLabel& label, const Notation& notation);

}  // namespace batten::editor
