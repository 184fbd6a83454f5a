/// A curve prepared for many points.
#pragma once

#include "core/evaluate/detail/interval_finder.h"
#include "core/evaluate/detail/taylor_pieces.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

/// Gives the points and derivatives of one curve: those of evaluate.h up to rounding, many times faster. Holds the
/// polynomial of every span, 8 bytes for each of some 2 (rational 3) p + 6 numbers, and a table that finds the span.
class Evaluator {
  public:
    /// Cost O(n p^3), with p^2 divisions for a span, several spans at once by vector instructions.
    explicit Evaluator(Curve curve);

    const Curve& curve() const { return curve_; }

    /// C(u); u is clamped to the domain (wrapped when periodic). At both ends of the domain bit-equal to point_at. Cost
    /// O(p), and O(log n) more where knots are spread very unevenly.
    Point point_at(double u, Side side = Side::right) const;

    /// C(u) and its derivatives to `order` >= 0, as derivatives_at gives them. Cost O(order p), and where rational
    /// O(order^2) more; no allocation up to order 3.
    Jet derivatives_at(double u, int order, Side side = Side::right) const;

  private:
    Curve curve_;
    Point start_{};
    Point end_{};
    TaylorPieces pieces_;
    IntervalFinder finder_;
};

}  // namespace batten::core
