/// Which knots of a smooth cubic it can do without.
#pragma once

#include <cstddef>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// The interior knots of multiplicity 1 of a cubic with equal weights, those first without which it changes least: they
/// are taken out one by one where the third derivative jumps least beside the lengths of the spans. Cost O(n log n).
std::vector<double> knots_by_need(const Curve& curve);

}  // namespace batten::core
