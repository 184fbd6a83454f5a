/// Rectangles of pixels.
#pragma once

#include <algorithm>
#include <glm/vec2.hpp>

namespace batten::render {

/// An axis-aligned rectangle of a picture: the corner nearest to the picture's own upper left one, and the farthest.
struct PixelBox {
    glm::dvec2 lower_px{};
    glm::dvec2 upper_px{};

    bool operator==(const PixelBox&) const = default;

    /// The box that has `a_px` and `b_px` as opposite corners.
    static PixelBox between(glm::dvec2 a_px, glm::dvec2 b_px) {
        return {{std::min(a_px.x, b_px.x), std::min(a_px.y, b_px.y)},
                {std::max(a_px.x, b_px.x), std::max(a_px.y, b_px.y)}};
    }

    [[nodiscard]] bool contains(glm::dvec2 place_px) const {
        return place_px.x >= lower_px.x && place_px.y >= lower_px.y && place_px.x <= upper_px.x &&
               place_px.y <= upper_px.y;
    }

    /// Whether they have more than parts of their edges in common.
    [[nodiscard]] bool overlaps(const PixelBox& other) const {
        return lower_px.x < other.upper_px.x && other.lower_px.x < upper_px.x && lower_px.y < other.upper_px.y &&
               other.lower_px.y < upper_px.y;
    }
};

}  // namespace batten::render
