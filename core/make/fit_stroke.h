/// The curve that a hand meant with a stroke.
#pragma once

#include <span>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// How smooth a curve near a stroke is: from the truest to the smoothest.
inline constexpr int least_smoothness = 0;
inline constexpr int usual_smoothness = 4;
inline constexpr int most_smoothness = 10;

struct StrokeRequest {
    double pixel = 1.0;  ///< how large a pixel is; a hand errs by about one
    int smoothness = usual_smoothness;
    bool may_close = true;  ///< whether a stroke that comes back to its beginning becomes periodic
};

/// The smooth cubic over [0, 1] near the samples of a stroke, `points`, that does not follow the noise of the hand.
/// Where the stroke turns at once, a knot has multiplicity 3. A greater smoothness never has more control points: up to
/// the usual one it decides how much of the hand is followed, and how near half a pixel the curve with fewer knots
/// stays; beyond, it allows twice that for every 5/3 steps. The samples in reverse order give the reversed curve, bit
/// for bit; all multiplied by a number, with the pixel, give the multiplied curve. Checked in this order:
/// data_points_too_few (1); data_point_not_finite; length_not_positive for the pixel; stroke_too_short (2 pixels wide
/// or high); not_computable. Assertion: `smoothness` is in its range. Cost O(m log m) for m samples.
///
/// It is a P-spline with spans of 12 pixels, its penalty chosen by generalised cross-validation, twice again with less
/// of it where the curve bends more sharply; of its knots those are left out that change it least; bends of its polygon
/// to the wrong side are taken out. Source: Eilers and Marx 1996, Flexible smoothing with B-splines and penalties;
/// Craven and Wahba 1979; Ruppert and Carroll 2000, Spatially-adaptive penalties for spline fitting.
[[nodiscard]] Result<Curve> fit_stroke(std::span<const Point> points, const StrokeRequest& request = {});

/// The smooth line through a stroke that goes on, while its pen moves: from the place of sample `from` to that of
/// sample `to`, `from` <= `to`, with several points for each of them. It ends exactly at the last sample where `to` is
/// this. Empty where the samples do not leave one place or are not such as fit_stroke takes. Cost O(m) for all m
/// samples.
[[nodiscard]] std::vector<Point> smooth_line(std::span<const Point> points, double pixel, std::size_t from,
                                             std::size_t to);

}  // namespace batten::core
