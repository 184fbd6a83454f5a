/// The numbers of the canvas's grid and rulers.
#pragma once

#include <string>

#include "app/editor/words/length.h"

namespace batten::editor {

/// Whether multiples of `step` are written as fractions of an inch: a half of one, a quarter, down to the 1024th.
bool is_inch_fraction(double step, const Units& units);

/// `value`, a multiple of `step` (> 0), both in the document's unit, with as many digits as tell neighboring multiples
/// apart: "1.5", "−20", "2 3/4" inches.
std::string grid_number_text(double value, double step, const Units& units = std::nullopt);

}  // namespace batten::editor
