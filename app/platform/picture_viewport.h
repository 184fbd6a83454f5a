/// Where the pictures of the window lie in its framebuffer, which may be denser than the window.
#pragma once

#include "app/ui/frame.h"
#include "render/gl_painter.h"

namespace batten::platform {

/// Framebuffer pixels for one window pixel; 1 for a window of no size.
double framebuffer_density(glm::ivec2 window_px, glm::ivec2 framebuffer_px);

/// The framebuffer pixels under `place`, whose edges are rounded, so that neighbors neither overlap nor leave a gap.
render::Viewport picture_viewport(const ui::Rectangle& place, glm::ivec2 window_px, glm::ivec2 framebuffer_px);

}  // namespace batten::platform
