/// What the lengths of a document are measured in.
#pragma once

#include <string>

#include "core/base/names.h"

namespace batten::core {

/// An inch is 25.4 mm or 96 px.
enum class LengthUnit { mm, inch, px };

/// How a document's coordinates become lengths.
struct DocumentUnits {
    LengthUnit unit = LengthUnit::mm;
    double scale = 1.0;             ///< how much of the world is one unit, above 0
    std::string unknown_members{};  ///< members that this version does not know, as a JSON object; empty if none
    bool operator==(const DocumentUnits&) const = default;
};

/// `length` of the one unit in the other. Rounded twice.
double converted(double length, LengthUnit from, LengthUnit to);

template <>
struct Names<LengthUnit> {
    using enum LengthUnit;
    static constexpr std::array table{Named{mm, "mm", "millimeters"}, Named{inch, "inch", "inches"},
                                      Named{px, "px", "pixels"}};
};

}  // namespace batten::core
