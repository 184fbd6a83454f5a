/// Gauss's rule for integrals of polynomials.
#pragma once

#include <cstddef>
#include <vector>

namespace batten::core {

/// One node on [-1, 1] and its weight.
struct GaussNode {
    double position = 0.0;
    double weight = 0.0;
};

/// The rule of `count` (>= 1) nodes, ascending: sum of weight f(position) is the integral of f over [-1, 1], exact for
/// polynomials up to degree 2 count - 1. Source: the zeros of Legendre's polynomial by Newton's iteration.
std::vector<GaussNode> gauss_rule(std::size_t count);

}  // namespace batten::core
