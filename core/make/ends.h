/// What a curve made from points does at its ends.
#pragma once

#include <optional>
#include <variant>

#include "core/base/geometry.h"

namespace batten::core {

/// Nothing is asked for at the ends.
struct FreeEnds {};

/// The second derivative is zero at both ends; degree 3 or more.
struct NaturalEnds {};

/// The derivative by u at one end or both; degree 2 or more. The domain has length 1 unless parameters are given, so
/// that a vector as long as the whole polygon through the points is a moderate one.
struct EndTangents {
    std::optional<Vector> start{};
    std::optional<Vector> end{};
};

/// A periodic curve that returns to the first point.
struct ClosedEnds {};

using Ends = std::variant<FreeEnds, NaturalEnds, EndTangents, ClosedEnds>;

}  // namespace batten::core
