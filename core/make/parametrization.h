/// Gives parameters to points that a curve shall pass, and knots to parameters.
#pragma once

#include <span>
#include <vector>

#include "core/base/names.h"
#include "core/curve/knot_vector.h"

namespace batten::core {

/// How far apart the parameters of neighboring points are, in proportion.
enum class Parametrization {
    uniform,     ///< all equally far
    chordal,     ///< as far as the points
    centripetal  ///< as the square roots of these distances
};

template <>
struct Names<Parametrization> {
    static constexpr std::array table{Named{Parametrization::uniform, "uniform", "uniform"},
                                      Named{Parametrization::chordal, "chordal", "chordal"},
                                      Named{Parametrization::centripetal, "centripetal", "centripetal"}};
};

/// Parameters from 0 to 1 for `points`, in order; when `is_closed` one more, 1, for the way back to the first point.
/// Errors: data_points_too_few (2; 3 when closed); data_point_not_finite; unless uniform, points_coincide, which names
/// the later of two neighbors that are equal or too near to be told apart beside the whole length. Source: The NURBS
/// Book, equations 9.3 to 9.6.
[[nodiscard]] Result<std::vector<double>> parametrize(std::span<const Point> points, Parametrization parametrization,
                                                      bool is_closed = false);

/// Checks points that come with `parameters`; the same errors but for points_coincide, and parameter_count_mismatch and
/// parameters_not_increasing.
[[nodiscard]] Result<void> check_parameters(std::span<const Point> points, std::span<const double> parameters,
                                            bool is_closed = false);

/// The full clamped vector for one control point at each of `sites` (at least p+1, not decreasing; p >= 1), each
/// interior knot the mean of p sites: u_{j+p} = (s_j + ... + s_{j+p-1}) / p. A site occurs twice where a derivative is
/// prescribed. Cost O(n p). Source: The NURBS Book, equation 9.8; de Boor 1978.
std::vector<double> averaged_knots(std::span<const double> sites, std::size_t p);

}  // namespace batten::core
