/// Curves that every format has to carry, each by a name.
#pragma once

#include <string>
#include <vector>

#include "core/document/document.h"

namespace batten::exchange {

struct CarriedCurve {
    std::string name;
    core::Curve curve;
};

/// Unequal weights, each multiplicity from 1 to the degree, tears, unclamped and periodic ones, degrees 1 and 25,
/// places 1e6 off, numbers of 1e150 and 1e-150; and `random_count` random ones, the same in every run.
std::vector<CarriedCurve> carried_curves(int random_count);

/// A document of this curve alone, or of several.
core::Document document_of(const core::Curve& curve, const std::string& name = "wave");
core::Document document_of(const std::vector<CarriedCurve>& curves);

}  // namespace batten::exchange
