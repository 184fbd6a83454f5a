#include "core/evaluate/detail/subdivide.h"

#include <cassert>

#include "core/curve/detail/bspline.h"

namespace batten::core {

std::pair<BezierPiece, BezierPiece> cut_piece(const BezierPiece& piece, double u) {
    assert(piece.interval.lower < u && u < piece.interval.upper);
    const Ratio ratio = ratio_between(piece.interval.lower, piece.interval.upper, u);
    BezierPiece left{{piece.interval.lower, u}, piece.span, {}};
    BezierPiece right{{u, piece.interval.upper}, piece.span, piece.points};
    left.points.reserve(piece.points.size());
    const std::size_t p = piece.points.size() - 1;
    for (std::size_t level = 0; level <= p; ++level) {
        left.points.push_back(right.points.front());
        for (std::size_t i = 0; i + level < p; ++i)
            right.points[i] = blend(right.points[i], right.points[i + 1], ratio);
    }
    return {std::move(left), std::move(right)};
}

double middle(Interval interval) {
    return interval.lower + 0.5 * interval.length();
}

Box control_box(const BezierPiece& piece) {
    Box box;
    for (const HomogeneousPoint& point : piece.points) box.include(project(point));
    return box;
}

}  // namespace batten::core
