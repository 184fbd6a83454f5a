/// A smooth piece of a curve through points, from one point at which something is given or nothing asked to the next.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/curve_error.h"
#include "core/base/geometry.h"

namespace batten::core {

/// At least two points and their parameters; the derivatives at both ends, natural where none is given.
struct SplineRun {
    std::span<const Point> places;
    std::span<const double> parameters;
    std::optional<Vector> start{};
    std::optional<Vector> end{};
};

/// The control points over clamped knots that occur once at each inner parameter. Cost O(n).
std::vector<Point> cubic_run(const SplineRun& run);

/// The same of degree 5. Error: equations_singular.
[[nodiscard]] Result<std::vector<Point>> quintic_run(const SplineRun& run);

}  // namespace batten::core
