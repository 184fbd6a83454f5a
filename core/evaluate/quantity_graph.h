/// Curvature and speed as graphs over the parameter, at a cost that depends on the plot and not on the curve.
#pragma once

#include <optional>
#include <vector>

#include "core/base/names.h"
#include "core/curve/curve.h"

namespace batten::core {

/// A number that a curve has at each parameter.
enum class Quantity {
    curvature,  ///< signed, as curvature_at gives it; none where the speed is zero
    speed       ///< |C'(u)|
};

template <>
struct Names<Quantity> {
    static constexpr std::array table{Named{Quantity::curvature, "curvature", "curvature"},
                                      Named{Quantity::speed, "speed", "speed"}};
};

/// The quantity at `u`, seen from `side` at a knot; none where there is none or it is no number.
std::optional<double> quantity_at(const Curve& curve, Quantity quantity, double u, Side side = Side::right);

struct GraphPoint {
    double u = 0.0;
    double value = 0.0;  ///< finite
};

/// Points of a graph in order of u.
using GraphRun = std::vector<GraphPoint>;

/// The graph over what `range` has in common with the domain, in order of u and at about `most` (>= 1) parameters or
/// fewer: over each span a run of its own, evenly spaced, from the one-sided value at its beginning to that at its end.
/// A run breaks where the quantity does not exist. Where the spans are too many for that, one value at each of `most`
/// evenly spaced parameters in one run.
std::vector<GraphRun> quantity_graph(const Curve& curve, Quantity quantity, Interval range, std::size_t most);

}  // namespace batten::core
