/// Points by their place within the domain.
#pragma once

#include "core/curve/curve.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

/// 0 is the lower end of the domain and 1 the upper one.
inline Point at_share(const Curve& curve, double share) {
    return point_at(curve, curve.domain().lower + share * (curve.domain().upper - curve.domain().lower));
}

}  // namespace batten::core
