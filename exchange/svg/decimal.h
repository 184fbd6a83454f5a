/// Decimal numbers in twice the precision of doubles.
#pragma once

#include <string_view>

#include "core/base/double_double.h"

namespace batten::exchange {

/// The number that `text` writes, of which `nearest` is the nearest double: "0.1" is a little less than the double 0.1.
/// `text` is as core::leading_number takes it; of its digits the first thirty count. `nearest` alone where that is not
/// between 1e-200 and 1e200. Cost O(length of the text).
core::DoubleDouble precise_decimal(std::string_view text, double nearest);

}  // namespace batten::exchange
