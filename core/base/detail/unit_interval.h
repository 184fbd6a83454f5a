/// Between an interval of parameters and [0, 1].
#pragma once

#include <cassert>

#include "core/base/geometry.h"

namespace batten::core {

/// The parameter at the share t of `interval`; its ends exactly at 0 and 1.
inline double from_unit(Interval interval, double t) {
    return t == 1.0 ? interval.upper : interval.clamp(interval.lower + t * interval.length());
}

/// The share of `interval`, not empty, that lies before `u`; in [0, 1].
inline double to_unit(Interval interval, double u) {
    assert(interval.lower < interval.upper);
    return std::clamp((u - interval.lower) / interval.length(), 0.0, 1.0);
}

}  // namespace batten::core
