/// Cuts lines and convex polygons to a rectangle, in doubles, so that far points do no harm to float vertices.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "render/pixel_box.h"

namespace batten::render {

/// The part of a segment: from `first` to `last`, fractions of its length in [0, 1].
struct SegmentPart {
    double first = 0.0;
    double last = 1.0;
};

/// The part of the segment from a to b inside `box`, or nothing (Liang and Barsky 1984).
std::optional<SegmentPart> clip_segment(const PixelBox& box, glm::dvec2 a, glm::dvec2 b);

/// The part of a convex polygon inside `box`; empty where there is none (Sutherland and Hodgman 1974).
std::vector<glm::dvec2> clip_polygon(const PixelBox& box, std::vector<glm::dvec2> polygon);

}  // namespace batten::render
