/// The basis functions as the plot shows them: over their whole supports, and round the period of a periodic curve.
#pragma once

#include <optional>

#include "core/evaluate/whole_basis.h"

namespace batten::editor {

class PlotBasis {
  public:
    /// Cost O(n) where an end of the vector is not clamped.
    explicit PlotBasis(const core::KnotVector& knots);

    /// The vector over which the functions are evaluated: its domain is all that a plot can show.
    const core::KnotVector& knots() const { return whole_.knots; }

    /// The function whose local number on a span of knots() is j, 0..p; none for those that no control point has.
    std::optional<std::size_t> function(std::size_t span, std::size_t j) const;

    /// N_i is this function of knots(): of those that repeat it in a periodic vector the first.
    std::size_t number_of(std::size_t i) const { return whole_.first + i; }

    /// How many functions and control points there are.
    std::size_t count() const { return count_; }

  private:
    core::WholeBasis whole_;
    std::size_t count_;
};

}  // namespace batten::editor
