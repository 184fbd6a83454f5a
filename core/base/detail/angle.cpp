#include "core/base/detail/angle.h"

#include <cmath>
#include <numbers>

namespace batten::core {

namespace {

double radians(double degrees) {
    return degrees * (std::numbers::pi / 180.0);
}

// The sine of 0 to 90 degrees; near 90 by the cosine, which is flat there.
double first_quarter_sine(double degrees) {
    if (degrees == 30.0) return 0.5;
    return degrees <= 45.0 ? std::sin(radians(degrees)) : std::cos(radians(90.0 - degrees));
}

// The sine of -180 to 180 degrees.
double sine(double degrees) {
    const double size = std::abs(degrees);
    return std::copysign(first_quarter_sine(size <= 90.0 ? size : 180.0 - size), degrees);
}

}  // namespace

Vector unit_vector(double degrees) {
    const double turned = std::remainder(degrees, 360.0);
    const double size = std::abs(turned);
    // At 45 the two agree, which sin and cos of the rounded angle need not.
    if (size == 45.0 || size == 135.0) {
        const double half = std::numbers::sqrt2 / 2.0;
        return {size == 45.0 ? half : -half, std::copysign(half, turned)};
    }
    const double x = size <= 90.0 ? first_quarter_sine(90.0 - size) : -first_quarter_sine(size - 90.0);
    return {x, sine(turned) + 0.0};
}

}  // namespace batten::core
