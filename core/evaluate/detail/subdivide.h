/// Cuts Bézier pieces and measures them; the common ground of tessellating and searching.
#pragma once

#include <utility>

#include "core/evaluate/bezier_pieces.h"

namespace batten::core {

/// The two parts of `piece` on both sides of `u`, strictly inside its interval. Cost O(p^2). Source: de Casteljau.
std::pair<BezierPiece, BezierPiece> cut_piece(const BezierPiece& piece, double u);

/// The middle of an interval; equal to one of its ends when no double lies between them.
double middle(Interval interval);

/// The box of the projected control points of a piece, which contains it.
Box control_box(std::span<const HomogeneousPoint> points);

/// The distance of `point` from the segment a..b.
double distance_to_segment(Point point, Point a, Point b);

/// A bound of the distance from the piece with these control points to its chord: C(u) is a mean of a point of the
/// chord and one of the inner hull.
double chord_deviation_bound(std::span<const HomogeneousPoint> points);

/// The same for a piece without weights.
double chord_deviation_bound(std::span<const Point> points);

/// More halvings than a double has digits find nothing new.
inline constexpr int most_chord_halvings = 60;

/// What halving a piece in `box` rounds: a bound that asks for less would chase noise.
double rounding_of_halving(const Box& box);

/// Whether a piece in `box` can be halved: a double lies inside its interval, and the box is finite.
bool is_divisible(Interval interval, const Box& box);

/// Whether a chord over `box` is at most 64 views long, or within the tolerance. A straight piece that is longer is
/// halved all the same, so that what goes to the screen stays within the range of its smaller numbers.
bool is_small_beside(const Box& box, const Box& view, double tolerance);

}  // namespace batten::core
