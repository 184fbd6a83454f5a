/// The member "fit" of a curve in native files: the points of which the curve is made.
#pragma once

#include <optional>

#include "core/document/detail/object_reader.h"
#include "core/make/fit_points.h"

namespace batten::core {

struct FitMember {
    FitPoints fit;
    std::string unknown_members;  ///< as a JSON object; empty if none
};

/// The fit points that the object `value` at `pointer` holds, checked completely.
[[nodiscard]] FileResult<FitMember> read_fit(Json& value, const std::string& pointer);

/// The object that read_fit reads back to equal points.
Json json_of_fit(const FitPoints& fit);

/// Whether `curve`, as it stands in the file, is the one through `fit`, but for what another machine may have rounded
/// otherwise: a millionth of its size.
bool is_curve_of(const FitPoints& fit, const Curve& curve);

}  // namespace batten::core
