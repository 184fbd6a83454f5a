/// The curve near given points, by least squares.
#pragma once

#include <span>

#include "core/base/progress.h"
#include "core/curve/approximation.h"
#include "core/make/ends.h"
#include "core/make/parametrization.h"

namespace batten::core {

struct FitRequest {
    int degree = 3;
    Parametrization parametrization = Parametrization::chordal;
    Ends ends = FreeEnds{};
    /// How much bending counts beside the errors: the curve has the least
    ///     sum |C(t_k) - Q_k|^2 + smoothing * integral |C^(r)(u)|^2 du,
    /// where r is `penalized_derivative`, 2 or 3, or the degree where that is less.
    double smoothing = 0.0;
    int penalized_derivative = 2;
};

/// The curve with `count` control points over [0, 1] that is nearest to `points`, and the largest distance of a point
/// to the curve at its own parameter, rounded up, which no distance to the curve exceeds. An open curve is clamped and
/// begins and ends exactly in the first and last point. The knots divide the points evenly, so that there are points in
/// every span and the curve is determined (Schoenberg and Whitney). The points in reverse order (of a closed curve
/// those after the first) give the reversed curve, bit for bit, knots included. Checked in this order:
/// degree_out_of_range; degree_too_low for the ends; those of parametrize; smoothing_negative; vector_not_finite;
/// data_points_too_few; too_few_points (p+1; 4 with two conditions at the ends; 2 when closed); control_points_too_many
/// (as many as points, and one more for each condition at an end); equations_singular; not_computable. Cost O(m p^2)
/// for m points. Source: The NURBS Book, 9.4.1, with knots that do not depend on the direction.
[[nodiscard]] Result<Approximation> fit(std::span<const Point> points, std::size_t count,
                                        const FitRequest& request = {}, const Progress& progress = {});

/// Such a curve with a largest distance of at most `tolerance`, with knots where they are needed: it begins as one
/// piece (closed: three), and a span with larger errors is halved, by the number of points in it, until there is none.
/// A tolerance that needs all the points is met by interpolation. Errors: those of fit; tolerance_not_positive;
/// tolerance_not_reached, which smoothing or a tolerance below the rounding of coordinates brings about. Cost O(m p^2)
/// for each of about log2(m) rounds.
[[nodiscard]] Result<Approximation> fit_within(std::span<const Point> points, double tolerance,
                                               const FitRequest& request = {}, const Progress& progress = {});

}  // namespace batten::core
