/// How true control points are that a file holds multiplied by their weights.
#pragma once

#include <vector>

namespace batten::exchange {

/// How far x is from product / weight, at most; infinity where one of them is not finite. For every size of the numbers
/// (weight > 0), also where the product has lost digits since it is tiny.
double quotient_error(double x, double weight, double product);

/// `weights`, or where they are all far from 1, those that draw the same: multiplied by the power of two that brings
/// the largest into [1, 2), unless that would round one.
std::vector<double> weights_near_one(std::vector<double> weights);

}  // namespace batten::exchange
