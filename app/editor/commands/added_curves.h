/// Curves of another document that become some of this one.
#pragma once

#include <vector>

#include "core/document/document.h"

namespace batten::editor {

/// Adds `curves`, which come of another document, at the end of the list: under free names, and linked and joined among
/// themselves alone, whatever numbers the links and marked joints of `document` have.
void add_curves(core::Document& document, std::vector<core::DocumentCurve> curves);

/// Gives each curve that is called as an earlier one a free name, since commands tell curves by their names.
void tell_names_apart(core::Document& document);

}  // namespace batten::editor
