/// The conditions that make the basis function of the uniform cubic what it is, with their numbers.
#pragma once

#include <array>
#include <optional>

#include "core/base/fraction.h"

namespace batten::core {

/// The polynomial b_j, by which the j-th of a segment's control points counts, j = 0..3: its coefficients of 1, t, t^2
/// and t^3, t = 0..1, the j-th column of uniform_cubic_matrix / 6. Over its support of four spans a basis function is
/// b_3, b_2, b_1, b_0.
std::array<Fraction, 4> uniform_cubic_piece(std::size_t j);

/// b_j(t), j = 0..3.
double uniform_cubic_value(std::size_t j, double t);

/// At a joint of the support both pieces have the same derivative; outside of the support the function is zero.
struct UniformCubicCondition {
    std::size_t joint = 0;                ///< 0..4, a knot of the support
    int order = 0;                        ///< 0..2, of the derivative
    std::optional<std::size_t> before{};  ///< j of the b_j that ends there, at t = 1; none at joint 0
    std::optional<std::size_t> after{};   ///< j of the b_j that begins there, at t = 0; none at joint 4
    Fraction left{};                      ///< the derivative of the one
    Fraction right{};                     ///< and of the other

    bool holds() const { return left == right; }
};

/// All fifteen, by joints and then by orders. They leave the sixteen coefficients one common factor.
std::array<UniformCubicCondition, 15> uniform_cubic_conditions();

/// The sixteenth, which settles that factor: b_0 + b_1 + b_2 + b_3 = 1, as the coefficients of the sum, 1, 0, 0, 0.
std::array<Fraction, 4> uniform_cubic_sum();

}  // namespace batten::core
