/// The curve through given points.
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/curve/curve.h"
#include "core/make/ends.h"
#include "core/make/parametrization.h"

namespace batten::core {

struct InterpolationRequest {
    int degree = 3;
    Parametrization parametrization = Parametrization::chordal;
    Ends ends = FreeEnds{};
    /// Parameters instead of the parametrization, and with them the domain; one for each point and, for closed ends,
    /// one more. Empty: the parametrization decides, over [0, 1].
    std::vector<double> parameters{};
};

/// A curve and the parameters at which it passes the points, in order.
struct Interpolation {
    Curve curve;
    std::vector<double> parameters;
};

/// The curve with C(parameters[k]) = points[k]. Open curves are clamped over averaged knots, and their ends are
/// bit-equal to the first and last point; those of a cubic with natural ends lie at the parameters, which makes it the
/// classical natural spline: of all curves through the points the one with the least integral of |C''|^2. Closed ones
/// have one control point for each point; of odd degree their knots lie at the parameters, of even degree midway
/// between them, where alone the equations are regular for equal steps, and all parameters are then larger by half of
/// the last step. Rotating the points of a closed curve gives the same curve. Checked in this order:
/// degree_out_of_range; degree_too_low for the ends; those of parametrize or check_parameters; data_points_too_few
/// (points and prescribed end derivatives together p+1); vector_not_finite; equations_singular, which only very uneven
/// parameters of closed curves bring about. Cost O(n p^2), of which O(n p) on points. Source: The NURBS Book, 9.2 and
/// A9.1; de Boor 1978.
[[nodiscard]] Result<Interpolation> interpolate(std::span<const Point> points, const InterpolationRequest& request = {},
                                                const Progress& progress = {});

}  // namespace batten::core
