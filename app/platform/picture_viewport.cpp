#include "app/platform/picture_viewport.h"

#include <glm/common.hpp>

namespace batten::platform {

double framebuffer_density(glm::ivec2 window_px, glm::ivec2 framebuffer_px) {
    return window_px.x > 0 ? static_cast<double>(framebuffer_px.x) / window_px.x : 1.0;
}

render::Viewport picture_viewport(const ui::Rectangle& place, glm::ivec2 window_px, glm::ivec2 framebuffer_px) {
    const double density = framebuffer_density(window_px, framebuffer_px);
    const glm::ivec2 lower(glm::round(place.origin_px * density));
    const glm::ivec2 upper(glm::round((place.origin_px + place.size_px) * density));
    return {lower, upper - lower, framebuffer_px};
}

}  // namespace batten::platform
