/// The de Boor algorithm as the insertion of u, as often as it takes until the new point is C(u).
#pragma once

#include <string>
#include <vector>

#include "app/editor/words/cell_names.h"

namespace batten::editor {

/// "u inserted once: P_{2}^{1}, P_{3}^{1}, P_{4}^{1} take the place of P_{2}, P_{3}", for each insertion, and last
/// "u inserted 3 times: the new point is C(u)". One line where u is a knot of such multiplicity that C(u) is a control
/// point already: "u is a knot of multiplicity 3: P_{3} is C(u)". Long lists have "…" in the middle.
std::vector<std::string> insertion_lines(const NamedTriangle& named);

}  // namespace batten::editor
