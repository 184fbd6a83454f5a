/// A curve that is made to begin as another one goes on, with the rest of it kept.
#pragma once

#include <vector>

#include "core/measure/meeting.h"
#include "core/measure/smoothness.h"
#include "core/refine/detail/joint_shape.h"

namespace batten::core {

/// The curve run through the other way, over the domain reflected at 0. Exact, and its own inverse.
[[nodiscard]] Result<Curve> seen_from_behind(const Curve& curve);

/// The same curve in `degree` at least.
[[nodiscard]] Result<Curve> raised_to(const Curve& curve, int degree);

/// A curve before and after its beginning was changed, both of one degree.
struct ChangedStart {
    Curve before;
    Curve after;
    double until = 0.0;  ///< behind it nothing changed; the lower end of the domain where nothing had to change at all
};

/// `curve`, clamped at both ends, made to begin as `wanted`, which continues `side`, in `least_degree` at least. A
/// polygon that only has to begin in another point stays one where that degree is 1. Errors: joint_turns_back; those of
/// elevate_degree.
[[nodiscard]] Result<ChangedStart> changed_start(const Curve& curve, const Passing& side, const Jet& wanted,
                                                 int least_degree);

/// What was lost by a curve that is seen from behind.
[[nodiscard]] std::vector<SmoothnessLoss> seen_from_behind(std::vector<SmoothnessLoss> losses);

/// Errors: curve_periodic; curve_closed where the ends meet.
[[nodiscard]] Result<void> check_has_ends(const Curve& curve);

}  // namespace batten::core
