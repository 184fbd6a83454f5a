/// Parts of a curve as chords of a known width, for finding the near ones among many without looking at the rest.
#pragma once

#include <algorithm>
#include <cassert>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace batten::core {

/// A part of a curve that goes from `from` to `to` and is nowhere farther from this chord than `width`. The width of a
/// short part is of the square of its length, which no box beside it can be.
struct Chord {
    Point from;
    Point to;
    double width = 0.0;
    double inverse_square;  ///< of the length; 0 for a chord of none

    Chord(Point begin, Point end)
        : from(begin), to(end), inverse_square(begin == end ? 0.0 : 1.0 / dot(end - begin, end - begin)) {}
};

inline double squared_distance(const Chord& chord, Point query) {
    const Vector along = chord.to - chord.from;
    const Vector away = query - chord.from;
    const Vector rest = away - std::clamp(dot(away, along) * chord.inverse_square, 0.0, 1.0) * along;
    return dot(rest, rest);
}

/// The chord of the polygon of `points`, at least one, and of whatever lies in its convex hull.
inline Chord chord_of(std::span<const Point> points) {
    Chord chord(points.front(), points.back());
    double square = 0.0;
    for (const Point& point : points) square = std::max(square, squared_distance(chord, point));
    chord.width = std::sqrt(square);
    return chord;
}

/// A binary tree over parts in their order: neighbors are joined, level by level. Cost of building O(n).
class ChordTree {
  public:
    /// At least one part.
    explicit ChordTree(std::vector<Chord> parts) {
        assert(!parts.empty());
        levels_.push_back(std::move(parts));
        while (levels_.back().size() > 1) levels_.push_back(joined(levels_.back()));
    }

    /// Calls `visit(i)` for the parts that are not left out by `is_too_far(squared distance of the chord, width,
    /// first)`, which is asked about parts joined of several from `first` on too; the nearer of two neighbors comes
    /// first, of equally near ones the first.
    template <class IsTooFar, class Visit>
    void visit_near(Point query, const IsTooFar& is_too_far, const Visit& visit) const {
        const double distance = squared_distance(levels_.back().front(), query);
        visit_below({levels_.size() - 1, 0, distance}, query, is_too_far, visit);
    }

  private:
    struct Node {
        std::size_t level;
        std::size_t i;
        double distance;
    };

    // Points of a segment are no farther from another one than its ends are.
    static Chord joined(const Chord& a, const Chord& b) {
        Chord both(a.from, b.to);
        const double beside_a = std::sqrt(squared_distance(both, a.to));
        const double beside_b = a.to == b.from ? beside_a : std::sqrt(squared_distance(both, b.from));
        both.width = std::max(beside_a + a.width, beside_b + b.width);
        return both;
    }

    static std::vector<Chord> joined(std::span<const Chord> parts) {
        std::vector<Chord> pairs;
        pairs.reserve((parts.size() + 1) / 2);
        for (std::size_t i = 0; i < parts.size(); i += 2)
            pairs.push_back(i + 1 < parts.size() ? joined(parts[i], parts[i + 1]) : parts[i]);
        return pairs;
    }

    template <class IsTooFar, class Visit>
    void visit_below(const Node& node, Point query, const IsTooFar& is_too_far, const Visit& visit) const {
        if (is_too_far(node.distance, levels_[node.level][node.i].width, node.i << node.level)) return;
        if (node.level == 0) return visit(node.i);
        const std::span<const Chord> below = levels_[node.level - 1];
        Node near{node.level - 1, 2 * node.i, squared_distance(below[2 * node.i], query)};
        if (near.i + 1 == below.size()) return visit_below(near, query, is_too_far, visit);
        Node far{near.level, near.i + 1, squared_distance(below[near.i + 1], query)};
        if (far.distance < near.distance) std::swap(near, far);
        visit_below(near, query, is_too_far, visit);
        visit_below(far, query, is_too_far, visit);
    }

    std::vector<std::vector<Chord>> levels_;  ///< the parts, pairs of them, pairs of pairs, ...
};

}  // namespace batten::core
