/// Which curve of the document before an edit each curve after it was.
#pragma once

#include <vector>

#include "core/document/document.h"

namespace batten::editor {

/// For each curve of `after` the one of `before` at its place, where there are as many and it has that name, else the
/// first with the very same curve, else the first of its name; null for a new one. Cost O(n log n) for n curves.
std::vector<const core::DocumentCurve*> old_entries(const core::Document& before, const core::Document& after);

}  // namespace batten::editor
