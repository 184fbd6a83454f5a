/// The pieces of a curve as polynomials, ready for finding where an expression in them changes its sign.
#pragma once

#include <functional>
#include <optional>

#include "core/evaluate/bezier_pieces.h"
#include "core/measure/detail/sign_runs.h"

namespace batten::core {

/// The power of two by which the forms of `curve` multiply coordinates, so that products of many neither overflow nor
/// vanish: the size of the curve is then about 1.
double form_scale(const Curve& curve);

/// A homogeneous piece A = (X, Y, W) and its derivatives over [0, 1], seen from the middle of the curve and scaled by
/// form_scale: forms 3k, 3k+1 and 3k+2 are X^(k), Y^(k), W^(k). The greatest weight of the curve is about 1. A constant
/// W has degree 0, so that what is polynomial stays of low degree. The errors allow for the rounding of the input too:
/// coordinates far from (0, 0) are known to fewer digits.
struct PieceForms {
    Interval interval;  ///< of the curve's parameters; the forms are over [0, 1]
    std::vector<Bernstein> forms;
};

/// The forms of all pieces with derivatives up to `order` (>= 0).
std::vector<PieceForms> piece_forms(const Curve& curve, int order);

/// Tells `take` the forms of those non-empty spans that are `wanted`, one after the other. Cost O(n) and that of
/// theirs.
void visit_piece_forms(const Curve& curve, int order, const std::function<bool(std::size_t span)>& wanted,
                       const std::function<void(const PieceForms&)>& take);

/// The signs of `expression` in forms up to `order` along the whole curve, over its domain. `expression` sees the forms
/// of a piece (see PieceForms); its sign must not depend on the length of the piece's interval.
std::vector<SignRun> sign_runs_along(const Curve& curve, int order, const Expression& expression);

/// The sign that `expression` has on all of a span, where that is known without its forms.
using KnownSign = std::function<std::optional<int>(std::size_t span)>;

/// The same, and what `known` knows is not looked for. Cost O(n) and that of the other spans.
std::vector<SignRun> sign_runs_along(const Curve& curve, int order, const Expression& expression,
                                     const KnownSign& known);

/// X' W - X W' and Y' W - Y W', which are W^2 times the hodograph of the piece. Needs order 1.
Bernstein hodograph_x(std::span<const Bernstein> forms);
Bernstein hodograph_y(std::span<const Bernstein> forms);

/// The sum of their squares: |C'|^2 up to a positive factor.
Bernstein speed_squared(std::span<const Bernstein> forms);

}  // namespace batten::core
