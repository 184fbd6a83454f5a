/// Curves that are there.
#pragma once

#include <utility>

#include "core/curve/curve.h"

namespace batten::core {

/// Of numbers that make a curve.
inline Curve made_curve(CurveDefinition definition) {
    return Curve::make(std::move(definition)).value();
}

}  // namespace batten::core
