/// Arrows along the curves, which tell how they are run through.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// A chevron pointing to where `direction` (of length 1, in pixels) leads.
void draw_chevron(CanvasFrame& frame, glm::dvec2 tip, glm::dvec2 direction, render::Color color);

/// Chevrons about every hundred pixels along what is seen of all visible curves; none on curves with more places than
/// the picture can hold.
void draw_directions(CanvasFrame& frame);

}  // namespace batten::editor
