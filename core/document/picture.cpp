#include "core/document/picture.h"

#include "core/base/detail/angle.h"

namespace batten::core {

Point plane_from_picture(const Picture& picture, PicturePlace place) {
    const Vector right = unit_vector(picture.rotation);
    const double up = picture.height - place.y;
    return picture.position + picture.scale * (place.x * right + up * turned_left(right));
}

PicturePlace picture_from_plane(const Picture& picture, Point point) {
    const Vector right = unit_vector(picture.rotation);
    const Vector offset = (point - picture.position) / picture.scale;
    return {dot(offset, right), picture.height - dot(offset, turned_left(right))};
}

}  // namespace batten::core
