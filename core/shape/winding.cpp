#include "core/shape/winding.h"

#include <limits>

#include "core/curve/control_box.h"
#include "core/shape/detail/crossing_tree.h"

namespace batten::core {

namespace {

std::vector<CrossingTree::Link> links_of(const Curve& curve) {
    std::vector<CrossingTree::Link> links;
    for (const BezierPiece& piece : bezier_pieces(curve)) {
        // Where the curve is torn, or its ends do not quite meet, a line goes on.
        if (!links.empty() && project(links.back().points.back()) != project(piece.points.front()))
            links.push_back({{links.back().points.back(), piece.points.front()}});
        links.push_back({piece.points});
    }
    links.push_back({{links.back().points.back(), links.front().points.front()}});
    return links;
}

}  // namespace

std::optional<int> winding_number(std::span<const Curve> curves, Point place) {
    int sum = 0;
    for (const Curve& curve : curves) {
        const Vector extent = control_box(curve).size();
        const double size = std::max(extent.x, extent.y);
        const Ray ray{.origin = {0.0, 0.0}, .slack = ray_slack_in_ulps * std::numeric_limits<double>::epsilon() * size};
        const auto crossings = CrossingTree(links_of(seen_from(curve, place))).crossings(ray);
        if (!crossings) return std::nullopt;
        sum += *crossings;
    }
    return sum;
}

}  // namespace batten::core
