/// A curve of Eigen's module Splines.
#pragma once

#include <unsupported/Eigen/Splines>

#include "core/curve/curve.h"

namespace batten::bench {

/// Of `Dimension` 2, or 3 for homogeneous points, which the caller projects.
template <int Dimension, int Degree>
Eigen::Spline<double, Dimension, Degree> eigen_curve(const core::Curve& curve) {
    using Spline = Eigen::Spline<double, Dimension, Degree>;
    const auto values = curve.knots().values();
    const auto n = static_cast<Eigen::Index>(curve.control_points().size());
    typename Spline::KnotVectorType knots(static_cast<Eigen::Index>(values.size()));
    for (Eigen::Index i = 0; i < knots.size(); ++i) knots[i] = values[static_cast<std::size_t>(i)];
    typename Spline::ControlPointVectorType points(Dimension, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const core::HomogeneousPoint point = curve.homogeneous_point(static_cast<std::size_t>(i));
        for (int k = 0; k < Dimension; ++k) points(k, i) = point[k];
    }
    return Spline(knots, points);
}

}  // namespace batten::bench
