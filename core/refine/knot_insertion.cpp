#include "core/refine/knot_insertion.h"

#include <cassert>

#include "core/refine/knot_refinement.h"

namespace batten::core {

Result<Curve> insert_knot(const Curve& curve, double u, int times, Tears tears) {
    assert(times >= 1);
    return refine_knots(curve, std::vector<double>(static_cast<std::size_t>(times), u), tears);
}

Result<Curve> insert_midpoint_knots(const Curve& curve) {
    const KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    std::vector<double> middles;
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s) {
        const double middle = knots[s] + 0.5 * (knots[s + 1] - knots[s]);
        const bool has_inside = knots[s] < middle && middle < knots[s + 1];
        if (has_inside) middles.push_back(middle);
    }
    return refine_knots(curve, std::move(middles));
}

}  // namespace batten::core
