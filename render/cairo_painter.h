/// Paints a picture with Cairo: figures for documents.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <tl/expected.hpp>

#include "render/draw_list.h"

namespace batten::render {

/// `picture` as an SVG file of `size_px` (> 0) units on a ground of `background`: the same lines, fills, marks and
/// labels as in the window, labels as outlines in the interface's fonts or what the system has for them. The error is a
/// sentence of Cairo's.
tl::expected<std::string, std::string> svg_text(const DrawList& picture, glm::dvec2 size_px, Color background);

}  // namespace batten::render
