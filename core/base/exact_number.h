/// Arithmetic with fractions that is exact or says that it cannot be.
#pragma once

#include <optional>

#include "core/base/fraction.h"

namespace batten::core {

/// A fraction; none once a numerator or denominator on the way to it left 64 bits, or something was divided by zero.
using ExactNumber = std::optional<Fraction>;

/// In lowest terms; none where a term is none already.
ExactNumber operator+(const ExactNumber& a, const ExactNumber& b);
ExactNumber operator-(const ExactNumber& a, const ExactNumber& b);
ExactNumber operator*(const ExactNumber& a, const ExactNumber& b);
ExactNumber operator/(const ExactNumber& a, const ExactNumber& b);

}  // namespace batten::core
