#include "core/document/picture.h"

#include <cmath>
#include <numbers>

namespace batten::core {

namespace {

// The direction of the lower edge; right angles exactly.
Vector direction_of(const Picture& picture) {
    constexpr double full_turn = 360.0;
    constexpr double right_angle = 90.0;
    const double degrees = std::remainder(picture.rotation, full_turn);
    if (std::remainder(degrees, right_angle) != 0.0) {
        const double radians = degrees * std::numbers::pi / 180.0;
        return {std::cos(radians), std::sin(radians)};
    }
    if (degrees == 0.0) return {1.0, 0.0};
    if (degrees == right_angle) return {0.0, 1.0};
    return degrees == -right_angle ? Vector(0.0, -1.0) : Vector(-1.0, 0.0);
}

}  // namespace

Point plane_from_picture(const Picture& picture, PicturePlace place) {
    const Vector right = direction_of(picture);
    const double up = picture.height - place.y;
    return picture.position + picture.scale * (place.x * right + up * turned_left(right));
}

PicturePlace picture_from_plane(const Picture& picture, Point point) {
    const Vector right = direction_of(picture);
    const Vector offset = (point - picture.position) / picture.scale;
    return {dot(offset, right), picture.height - dot(offset, turned_left(right))};
}

}  // namespace batten::core
