/// The outlines of what is dark in an image, as closed curves.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/curve/curve.h"
#include "core/make/contours.h"

namespace batten::core {

/// How the outlines of an image are traced; lengths are in pixels.
struct TraceRequest {
    std::optional<double> threshold{};  ///< from 0 to 255; what is darker is outlined. None: middle_shade
    double tolerance = 0.3;             ///< how far a curve may be from the contour that it stands for, > 0
    double speckle = 4.0;               ///< what is of less area, or a hole of less, is left out, >= 0
    bool is_inverted = false;           ///< outlines what is light instead, in an image that is dark around
};

/// Of more outlines, speckles not counted, the largest are traced.
inline constexpr std::size_t most_outlines = 20'000;

struct Trace {
    std::vector<Curve> curves;  ///< outlines counterclockwise, those of holes clockwise, the largest first
    double error = 0.0;         ///< the largest distance of a contour to its curve, an upper bound
    double threshold = 0.0;     ///< that was used
    std::size_t left_out = 0;   ///< outlines beyond most_outlines
};

/// The outlines in `image` as closed, periodic curves within the tolerance of its contours, in the coordinates of
/// `contours`. Where an outline has a corner the curve has one, a knot of multiplicity p where its two sides meet when
/// they are continued; a corner is told from a bend by how long its sides are. Straight stretches are straight, and
/// those between two corners so exactly; an outline of nothing else is a polygon of degree 1. All else is cubic, fitted
/// with as few knots as fit_within needs; a smooth outline is C2. Errors: tolerance_not_positive; those of fit_within.
/// Cost O(pixels), and that of the fits.
[[nodiscard]] Result<Trace> trace(const GrayImage& image, const TraceRequest& request = {},
                                  const Progress& progress = {});

/// One contour in that way. Errors: those of fit_within.
struct TracedContour {
    Curve curve;
    double error = 0.0;
};
[[nodiscard]] Result<TracedContour> trace_contour(const Contour& contour, double tolerance);

}  // namespace batten::core
