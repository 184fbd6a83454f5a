/// Curves of another document that become some of this one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor/command_spec.h"
#include "app/editor/words/length.h"
#include "core/document/document.h"

namespace batten::editor {

/// Adds `curves`, which come of another document, at the end of the list: under free names, and linked and joined among
/// themselves alone, whatever numbers the links and marked joints of `document` have.
void add_curves(core::Document& document, std::vector<core::DocumentCurve> curves);

/// What coordinates of a document measured in `from` are multiplied by so that lengths stay as long in one measured in
/// `to`; 1 where either has plain numbers.
double coordinate_factor(const Units& from, const Units& to);

/// Brings all that has a place in `document` to the coordinates of one measured in `units`, and says so where that
/// changes them. Where either has plain numbers nothing changes. The refusal is that of a curve that becomes too large
/// or too small. Cost O(n) where anything changes.
[[nodiscard]] Outcome<std::optional<std::string>> convert_units(core::Document& document, const Units& units);

/// Gives each curve that is called as an earlier one a free name, since commands tell curves by their names.
void tell_names_apart(core::Document& document);

}  // namespace batten::editor
