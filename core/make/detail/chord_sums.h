/// Lengths of the way along points, in twice the precision.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/make/parametrization.h"

namespace batten::core {

/// The share of the way that lies before each point, from 0 to 1, as if it were computed in twice the precision and
/// rounded once; as many as points, and one more where the way leads back to the first point. Chords count with their
/// lengths or, centripetal, the roots of these. None where points coincide, or are so near or far that the squares of
/// their distances lose digits. Cost O(n).
std::optional<std::vector<double>> shares_of_way(std::span<const Point> points, Parametrization parametrization,
                                                 bool is_closed);

}  // namespace batten::core
