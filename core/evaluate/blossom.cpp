#include "core/evaluate/blossom.h"

#include <cassert>

#include "core/curve/detail/bspline.h"

namespace batten::core {

HomogeneousPoint blossom(const Curve& curve, std::size_t span, std::span<const double> arguments) {
    const SpanKnots at(curve.knots(), span);
    assert(arguments.size() == at.p);
    auto points = local_points(curve, at);
    for (std::size_t r = 1; r <= at.p; ++r) blend_level(points, at, r, arguments[r - 1]);
    return points[at.p];
}

}  // namespace batten::core
