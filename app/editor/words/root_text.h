/// Numbers that are roots of small fractions, as weights of circles are.
#pragma once

#include <string>

#include "app/editor/state/notation.h"

namespace batten::editor {

/// "√2/2" where `value` is the root of a small fraction and `notation` has fractions, else its exact_text.
std::string root_text(const Notation& notation, double value);

}  // namespace batten::editor
