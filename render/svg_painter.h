/// Paints figures as SVG of few bytes that a person can edit: labels are text.
#pragma once

#include <string>

#include "render/figure.h"

namespace batten::render {

/// `figure` as an SVG file: the same lines, fills, marks and labels as in the window. Labels are text in the
/// interface's fonts, or what the viewer has for them; ink is a picture.
std::string svg_text(const Figure& figure);

}  // namespace batten::render
