/// Where a polynomial, or an expression in several of them, is positive, negative and zero.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/measure/detail/bernstein.h"

namespace batten::core {

/// A stretch of constant sign. Where `sign` is 0 the value cannot be told from zero: a zero, which has no length, or a
/// whole piece on which the expression vanishes.
struct SignRun {
    Interval where;
    int sign = 0;

    bool operator==(const SignRun&) const = default;
};

/// A polynomial made of the given ones by products, sums and derivatives with respect to a common parameter.
using Expression = std::function<Bernstein(std::span<const Bernstein>)>;

/// The signs of `expression` in `forms` over [0, 1], in order and without gaps. Found by halving the forms until the
/// coefficients of the expression have at most one change of sign (variation diminishing), so none is missed; a simple
/// zero is then enclosed by Newton's iteration, a multiple one found once, as a simple zero of a derivative. Zeros
/// nearer to each other than doubles can tell are one. Source: Lane and Riesenfeld 1981.
std::vector<SignRun> sign_runs(std::vector<Bernstein> forms, const Expression& expression);

/// The signs of `a` over [0, 1].
std::vector<SignRun> sign_runs(const Bernstein& a);

/// The zeros of `a` in [0, 1], ascending, multiple ones once; none where it vanishes everywhere.
std::vector<double> roots(const Bernstein& a);

/// `run` put behind `runs`, joined with the last one if that has the same sign. Both are adjacent.
void append_run(std::vector<SignRun>& runs, SignRun run);

/// A place between runs of definite sign: zeros, or a jump from one sign to the other.
struct SignEvent {
    Interval where;        ///< of no length but where the expression vanishes on a stretch
    int before = 0;        ///< the sign before, 0 at the beginning
    int after = 0;         ///< the sign after, 0 at the end
    bool is_jump = false;  ///< from one sign to the other without a zero between

    bool is_change() const { return before * after < 0; }
};

/// The events of runs in order. In cyclic ones the last run is followed by the first, and an event there, or a stretch
/// across the seam, is given from its beginning on unwrapped, so that it may leave the domain at the upper end; an
/// event at the seam itself is at the lower end.
std::vector<SignEvent> sign_events(std::span<const SignRun> runs, bool is_cyclic = false);

}  // namespace batten::core
