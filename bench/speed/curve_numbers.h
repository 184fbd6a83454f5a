/// The control points of what a library answers, as numbers.
#pragma once

#include "bench/peers/occt_curve.h"
#include "bench/peers/sisl_curve.h"
#include "contest.h"

namespace batten::bench {

struct ControlPoints {
    Numbers operator()(const core::Curve& curve) const {
        Numbers numbers;
        for (const core::Point& point : curve.control_points()) numbers.insert(numbers.end(), {point.x, point.y});
        return numbers;
    }
    Numbers operator()(const core::Result<core::Curve>& curve) const { return (*this)(curve.value()); }

    /// Of a polynomial curve.
    Numbers operator()(const SislCurve& curve) const {
        return Numbers(curve->ecoef, curve->ecoef + static_cast<std::ptrdiff_t>(curve->in) * curve->idim);
    }

    Numbers operator()(const OcctCurve& curve) const {
        Numbers numbers;
        for (const gp_Pnt2d& pole : curve->Poles()) numbers.insert(numbers.end(), {pole.X(), pole.Y()});
        return numbers;
    }
};

}  // namespace batten::bench
