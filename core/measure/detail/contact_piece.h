/// Pieces of curves as the search for their intersections sees them: boxes, directions, halves.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry.h"

namespace batten::core {

/// The directions of all tangents of a piece, when they span less than half a turn: angles from `middle - half_width`
/// to `middle + half_width`.
struct DirectionCone {
    double middle = 0.0;
    double half_width = 0.0;
};

/// A part of one Bézier piece.
struct ContactPiece {
    std::size_t span = 0;                     ///< which of the curve's pieces
    Interval shares;                          ///< which part of it, in [0, 1]
    std::vector<HomogeneousPoint> points;     ///< the part's control points
    std::vector<Point> shadow;                ///< the same, projected
    Box box;                                  ///< of the shadow
    std::optional<DirectionCone> directions;  ///< none where they span half a turn or more, or there are none

    /// There is at least one control point.
    ContactPiece(std::size_t span_index, Interval share_interval, std::vector<HomogeneousPoint> control_points);

    double size() const { return std::max(box.size().x, box.size().y); }

    /// No interval of doubles is shorter, or so short that halves of it make no sense.
    bool is_divisible() const { return shares.length() > 1e-14; }
};

/// Both halves. Cost O(p^2).
std::pair<ContactPiece, ContactPiece> halves(const ContactPiece& piece);

/// Whether the pieces are farther apart than `distance`, as far as their boxes, along the axes and along both chords,
/// prove it.
bool are_apart(const ContactPiece& a, const ContactPiece& b, double distance);

/// Whether no tangent of one is parallel to one of the other, so that they meet at most once.
bool are_transversal(const ContactPiece& a, const ContactPiece& b);

/// Whether `a`, continued by `b`, turns by less than half a turn altogether, so that they meet at their joint only.
bool continue_each_other(const ContactPiece& a, const ContactPiece& b);

}  // namespace batten::core
