/// A part of an offset as a cubic with C2 and few points.
#pragma once

#include "core/curve/approximation.h"
#include "core/shape/detail/offset_source.h"

namespace batten::core {

/// The offset over `part`, of positive length, as a clamped cubic; over the whole domain of a source that is smoothly
/// closed a periodic one. The error is measured between the samples that were fitted. Errors: curve_stands_still;
/// tolerance_not_reached; not_computable. Source: the cubic spline through places of the offset, by its length, with
/// its tangents at the ends; where it is too far away, the number of places is doubled.
[[nodiscard]] Result<Approximation> fit_offset(const OffsetSource& source, Interval part, double tolerance);

/// The offset over `part` at the parameters of the source, as a cubic with C1 and as many points as it takes. Errors:
/// curve_stands_still; tolerance_not_reached. Source: Hermite interpolation.
[[nodiscard]] Result<Curve> raw_offset(const OffsetSource& source, Interval part, double tolerance);

}  // namespace batten::core
