#include "app/editor/pointer/direction.h"

#include <cmath>
#include <numbers>

#include "core/edit/plane_map.h"

namespace batten::editor {

double degrees_of(core::Vector way) {
    constexpr double eighth = 45.0;
    constexpr double half_turn = 180.0;
    const double degrees = std::atan2(way.y, way.x) * half_turn / std::numbers::pi;
    const double exact = eighth * std::round(degrees / eighth);
    const bool is_eighth = way.x == 0.0 || way.y == 0.0 || std::abs(way.x) == std::abs(way.y);
    return is_eighth ? exact : degrees;
}

core::Vector direction_of(double degrees) {
    return core::vector_to(core::mapped(core::rotation(degrees, {0.0, 0.0}), {1.0, 0.0}));
}

core::Vector direction_of(core::Vector way) {
    constexpr double rounding = 1e-9;
    const double degrees = degrees_of(way);
    const double whole = std::round(degrees);
    return std::abs(degrees - whole) <= rounding ? direction_of(whole) : way / core::robust_length(way);
}

}  // namespace batten::editor
