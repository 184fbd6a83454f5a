/// The recurrence of the basis functions, their polynomials and derivatives as text, in the label notation of
/// render::Label.
#pragma once

#include <array>
#include <string>

#include "app/editor/state/notation.h"
#include "core/evaluate/basis_pieces.h"
#include "core/evaluate/basis_triangle.h"

namespace batten::editor {

/// A knot or a parameter: a fraction of small numbers, else with the decimals that tell places in the domain apart.
std::string knot_value_text(const core::KnotVector& knots, double u, const Notation& notation);

/// "N_{0,3}".
std::string basis_name(std::size_t i, std::size_t k);

/// How a cell of the triangle comes about: of two summands, each a line of its own.
struct RecurrenceFormula {
    /// "N_{0,2} = (u − u_{0})/(u_{2} − u_{0}) N_{0,1}" and "+ (u_{3} − u)/(u_{3} − u_{1}) N_{1,1}".
    std::array<std::string, 2> symbols;
    /// "= (3/2 − 0)/(2 − 0) · 1/2" and "+ (3 − 3/2)/(3 − 1) · 1/2"; 0/0 where knots coincide.
    std::array<std::string, 2> knots;
    std::string numbers;  ///< "= 3/4 · 1/2 + 3/4 · 1/2 = 3/4"
    std::string note;     ///< what a ratio 0/0 counts as, and why; else empty
};

/// Of cell `index` of a level >= 1.
RecurrenceFormula recurrence_formula(const core::KnotVector& knots, const core::BasisTriangle& triangle,
                                     std::size_t level, std::size_t index, const Notation& notation);

/// Why N_{i,0} is 1 or 0 at u: "N_{1,0} = 1, because u = 1.5 is in [u_{1}, u_{2}) = [1, 2)".
std::string step_formula(const core::KnotVector& knots, const core::BasisTriangle& triangle, std::size_t index,
                         const Notation& notation);

/// "B_{1,3} = u B_{0,2} + (1 − u) B_{1,2}", of a Bézier curve over [0, 1] and a degree n >= 1.
std::string bernstein_recurrence(std::size_t i, std::size_t n);

/// The derivative of N_{i,p} by the functions one degree lower, in symbols and with the factors put in:
/// "N′_{0,3} = 3/(u_{3} − u_{0}) N_{0,2} − 3/(u_{4} − u_{1}) N_{1,2}" and "= 1 N_{0,2} − 1 N_{1,2}"; of a Bézier curve
/// "B′_{1,3} = 3/(u_{4} − u_{1}) B_{0,2} − 3/(u_{5} − u_{2}) B_{1,2}".
struct BasisDerivativeFormula {
    std::string symbols;
    std::string numbers;
};
BasisDerivativeFormula basis_derivative_formula(const core::KnotVector& knots, std::size_t i, const Notation& notation);

/// "(−3t^{3} + 3t^{2} + 3t + 1)/6", "u^{3}/6", "0.25u − 1.414": over one denominator where the coefficients are
/// fractions that can be read, else with four digits.
std::string polynomial_text(const core::PowerForm& form, const std::string& variable, const Notation& notation);

}  // namespace batten::editor
