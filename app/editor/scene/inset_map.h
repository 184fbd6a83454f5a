/// Where an inset shows a place.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

#include "core/base/geometry.h"
#include "render/pixel_box.h"

namespace batten::editor {

/// Maps what lies in a box of the world into an area of the picture, by one scale.
class InsetMap {
  public:
    InsetMap(const render::PixelBox& area, const core::Box& box) {
        const glm::dvec2 room = area.upper_px - area.lower_px;
        // Halves first: the difference of two huge values may not be finite.
        const core::Vector half = 0.5 * core::vector_to(box.upper) - 0.5 * core::vector_to(box.lower);
        const double larger = std::max(half.x / room.x, half.y / room.y);
        middle_ = core::middle(box.upper, box.lower);
        scale_ = larger > 0.0 && std::isfinite(1.0 / larger) ? 0.5 / larger : 0.0;
        center_ = area.lower_px + 0.5 * room;
    }

    double scale() const { return scale_; }

    /// What is shown at `place`; the middle of the box where that is too large to be shown.
    core::Point shown_at(glm::dvec2 place) const {
        if (scale_ == 0.0) return middle_;
        return {middle_.x + (place.x - center_.x) / scale_, middle_.y - (place.y - center_.y) / scale_};
    }

    glm::dvec2 operator()(core::Point tip) const {
        return center_ + scale_ * glm::dvec2(tip.x - middle_.x, middle_.y - tip.y);
    }

  private:
    core::Point middle_{};
    glm::dvec2 center_{};
    double scale_ = 0.0;
};

}  // namespace batten::editor
