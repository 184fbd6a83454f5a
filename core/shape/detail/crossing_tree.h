/// How often a chain of Bézier pieces passes beside a place, which makes winding numbers.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/evaluate/bezier_pieces.h"

namespace batten::core {

/// Control points of a piece, one dimension up.
using PiecePoints = std::vector<HomogeneousPoint>;

/// Both halves of a piece at share `t` of its parameter. Cost O(p^2). Source: de Casteljau.
std::pair<PiecePoints, PiecePoints> halved(const PiecePoints& points, double t = 0.5);

/// The coordinate axis along which a ray runs from a place to infinity, in the positive sense.
enum class RayAxis { x, y };

/// The slack of a ray beside the size of what it may cross.
inline constexpr double ray_slack_in_ulps = 4.0;

/// A ray and how near to its origin is on it.
struct Ray {
    Point origin{};
    RayAxis axis = RayAxis::x;
    double slack = 0.0;
};

/// How often a piece crosses the ray to the left, seen along it, less how often to the right. A piece whose box does
/// not contain the origin crosses as its chord does. None where the piece passes through the origin, within the slack.
std::optional<int> ray_crossings(const PiecePoints& piece, const Ray& ray);

/// The same for a piece that begins (or, with `at_end`, ends) in the origin, without the crossing there.
std::optional<int> ray_crossings_beyond(const PiecePoints& piece, const Ray& ray, bool at_end);

/// A chain of pieces, each beginning where the one before ends, as a tree of boxes.
class CrossingTree {
  public:
    /// A piece and its number, by which it can be left out.
    struct Link {
        PiecePoints points;
        std::size_t number = 0;
    };

    explicit CrossingTree(std::vector<Link> links);

    /// The crossings of all links but those of number `left_out`, which must pass through the origin. None where
    /// another one does. Cost O(log n) and that of the links near the ray's origin.
    std::optional<int> crossings(const Ray& ray, std::optional<std::size_t> left_out = std::nullopt) const;

  private:
    struct Node {
        Box box;
        Point first{};
        Point last{};
    };

    std::optional<int> below(std::size_t level, std::size_t i, const Ray& ray,
                             std::optional<std::size_t> left_out) const;

    std::vector<Link> links_;
    std::vector<std::vector<Node>> levels_;
};

}  // namespace batten::core
