#include "app/editor/derived/plot_basis.h"

namespace batten::editor {

PlotBasis::PlotBasis(const core::KnotVector& knots)
    : whole_(knots.is_periodic() ? core::WholeBasis{knots} : core::whole_basis(knots)),
      count_(knots.control_point_count()) {}

std::optional<std::size_t> PlotBasis::function(std::size_t span, std::size_t j) const {
    const std::size_t number = span - static_cast<std::size_t>(knots().degree()) + j;
    if (knots().is_periodic()) return number % count_;
    if (number < whole_.first || number - whole_.first >= count_) return std::nullopt;
    return number - whole_.first;
}

}  // namespace batten::editor
