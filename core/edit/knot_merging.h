/// Makes near-equal knots equal.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// What came of merging knots.
struct KnotMerging {
    Curve curve;
    int count = 0;       ///< how many knots moved
    double error = 0.0;  ///< a bound of the deviation
};

/// The curve with near-equal knots made equal; its control points stay, so its shape changes by about as much as the
/// knots move, and the error is measured. Runs of knots that follow each other within `tolerance` (> 0, relative to the
/// length of the domain) of the first of them are merged from left to right, as many as fit into the multiplicity p
/// (p+1 at an end of the domain); they take the value of the longest run, the first of equals, or of the end of the
/// domain among them. Knots outside the domain stay. Errors: tolerance_not_positive; domain_empty when all would be
/// merged.
[[nodiscard]] Result<KnotMerging> merge_knots(const Curve& curve, double tolerance);

}  // namespace batten::core
