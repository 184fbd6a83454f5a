/// The curves, parameters and points on which libraries are compared; the same in every run.
#pragma once

#include <vector>

#include "core/curve/curve.h"

namespace batten::bench {

/// A clamped curve of `n` control points along a spiral that wavers, its knots at uneven distances, over [0, 1]. The
/// weights of a rational one are from 0.5 to 2.
core::Curve spiral(std::size_t n, int degree = 3, bool is_rational = false);

/// `count` parameters of [0, 1] at equal distances, both ends among them.
std::vector<double> sorted_parameters(std::size_t count);

/// `count` parameters of [0, 1) in no order.
std::vector<double> random_parameters(std::size_t count);

/// `count` points of the wavering spiral, neighbors at uneven distances.
std::vector<core::Point> points_on_spiral(std::size_t count);

}  // namespace batten::bench
