/// How far a curve is from the points that it was fitted to.
#pragma once

#include <span>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// A bound of the distance of each point to the polynomial `curve` at its parameter, to which `shift` is added. The
/// largest of them is sharp: what may be it is seen in twice the precision, because of a curve through the points
/// rounding is all there is. Cost O(p^2) for each.
std::vector<double> fit_errors(const Curve& curve, std::span<const Point> points, std::span<const double> parameters,
                               double shift);

}  // namespace batten::core
