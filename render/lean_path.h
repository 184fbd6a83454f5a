/// Places as figures have them: few digits, and no more points than can be told apart.
#pragma once

#include <string>
#include <vector>

#include "render/draw_list.h"

namespace batten::render {

/// `points` without those nearer than 0.05 px to the one kept before; the last one stays.
std::vector<Pixel> lean_points(const std::vector<Pixel>& points);

/// The corners of a diamond or a square.
std::vector<Pixel> marker_corners(const Marker& marker);

/// With at most two decimals: "12.5", "-3", "0".
std::string short_number(double number);

/// "12.5 -3": a place, its numbers with `between` them.
std::string short_place(glm::dvec2 place, char between = ' ');

}  // namespace batten::render
