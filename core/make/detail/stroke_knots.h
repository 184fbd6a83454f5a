/// The knots over which a cubic follows a stroke.
#pragma once

#include <span>
#include <vector>

#include "core/curve/knot_vector.h"
#include "core/make/detail/stroke_samples.h"

namespace batten::core {

/// Where the spans of a curve along a stroke meet, from the beginning to the end of the way, which for a closed stroke
/// is one turn from its first corner on.
struct StrokeBreaks {
    std::vector<double> stations{};
    std::vector<double> corners{};  ///< those of the stations that have multiplicity 3
    bool is_closed = false;

    double length() const { return stations.back() - stations.front(); }
};

/// Even spans of about `span` between corners, no more of them there than samples, and three at least around a closed
/// stroke. Cost O(m).
StrokeBreaks even_breaks(const Stroke& stroke, std::vector<double> corners, double span);

/// The breaks without the stations in `gone`, which are no corners.
StrokeBreaks without(const StrokeBreaks& breaks, std::vector<double> gone);

/// The knots of a cubic over the breaks, clamped or periodic.
Result<KnotVector> knots_over(const StrokeBreaks& breaks);

}  // namespace batten::core
