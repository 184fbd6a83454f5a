/// How far apart two curves are as shapes.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// A bound of the distance between two curves whatever their parameters are: no point of either curve is farther from
/// the other one. The curves are passed through together, from beginning to end, one waiting for the other where that
/// brings them nearer. So the bound is greater than the largest distance to a nearest point by up to a percent or a
/// thousandth of largest_deviation(), and by more where a curve turns back on itself or is closed and its seam slides;
/// it is never greater than largest_deviation(), which it is for curves that differ in more than 1000 spans. Cost
/// O(p^2) for each span in which they differ and each of up to some hundred halvings. Source: Alt and Godau 1995 (the
/// Fréchet distance).
double geometric_distance(const Curve& a, const Curve& b);

}  // namespace batten::core
