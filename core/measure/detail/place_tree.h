/// Boxes by where they are, for finding those near a place among many, whatever the order in which they come.
#pragma once

#include <algorithm>
#include <cassert>
#include <numeric>
#include <vector>

#include "core/base/geometry.h"

namespace batten::core {

/// The square of how far `place` is from a box that is not empty; 0 inside.
inline double squared_distance(const Box& box, Point place) {
    const Vector away{place.x - std::clamp(place.x, box.lower.x, box.upper.x),
                      place.y - std::clamp(place.y, box.lower.y, box.upper.y)};
    return dot(away, away);
}

/// A binary tree: boxes are halved by their middles, across the longer side of where these lie. Source: Bentley 1975,
/// Multidimensional binary search trees.
class PlaceTree {
  public:
    /// At least one box, none empty. Cost O(n log n).
    explicit PlaceTree(const std::vector<Box>& boxes) : order_(boxes.size()), nodes_(2 * boxes.size() - 1) {
        assert(!boxes.empty());
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        build(boxes, {0, 0, boxes.size()});
    }

    /// Calls `visit(i)` for the boxes that are not left out by `is_too_far(squared distance)`, which is asked about
    /// boxes around several too; the nearer of two halves comes first. Cost O(log n) and that of what is visited.
    template <class IsTooFar, class Visit>
    void visit_near(Point place, const IsTooFar& is_too_far, const Visit& visit) const {
        visit_below({0, 0, order_.size()}, place, is_too_far, visit);
    }

  private:
    /// The node of order_[first..end-1]. One of c boxes is followed by the 2c - 2 nodes below it, first half first.
    struct Node {
        std::size_t index;
        std::size_t first;
        std::size_t end;

        bool is_leaf() const { return end == first + 1; }
        std::size_t middle() const { return first + (end - first) / 2; }
        Node first_half() const { return {index + 1, first, middle()}; }
        Node second_half() const { return {index + 2 * (middle() - first), middle(), end}; }
    };

    void build(const std::vector<Box>& boxes, const Node& node) {
        Box& around = nodes_[node.index];
        if (node.is_leaf()) {
            around = boxes[order_[node.first]];
            return;
        }
        Box middles;
        for (std::size_t k = node.first; k < node.end; ++k) middles.include(center_of(boxes[order_[k]]));
        const bool is_wide = middles.size().x >= middles.size().y;
        const auto at = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
        std::nth_element(at(node.first), at(node.middle()), at(node.end), [&](std::size_t a, std::size_t b) {
            const Point of_a = center_of(boxes[a]);
            const Point of_b = center_of(boxes[b]);
            return is_wide ? of_a.x < of_b.x : of_a.y < of_b.y;
        });
        for (const Node& half : {node.first_half(), node.second_half()}) {
            build(boxes, half);
            around.include(nodes_[half.index].lower);
            around.include(nodes_[half.index].upper);
        }
    }

    // Sums of halves do not overflow.
    static Point center_of(const Box& box) { return core::middle(box.lower, box.upper); }

    template <class IsTooFar, class Visit>
    void visit_below(const Node& node, Point place, const IsTooFar& is_too_far, const Visit& visit) const {
        if (is_too_far(squared_distance(nodes_[node.index], place))) return;
        if (node.is_leaf()) return visit(order_[node.first]);
        Node near = node.first_half();
        Node far = node.second_half();
        if (squared_distance(nodes_[far.index], place) < squared_distance(nodes_[near.index], place))
            std::swap(near, far);
        visit_below(near, place, is_too_far, visit);
        visit_below(far, place, is_too_far, visit);
    }

    std::vector<std::size_t> order_;
    std::vector<Box> nodes_;
};

}  // namespace batten::core
