/// Turns polylines into strips of triangles that share their vertices at gentle turns.
#pragma once

#include <glm/vec2.hpp>

#include "render/draw_list.h"
#include "render/mesh.h"
#include "render/pixel_box.h"

namespace batten::render {

/// One corner of a strip. The fragment shader finds the distance to the center line from `along_px` and `across_px`.
struct StrokeVertex {
    glm::vec2 position_px{};
    float along_px = 0.0F;   ///< arc length, as the dashes count it
    float across_px = 0.0F;  ///< signed distance from the center line
    float first_px = 0.0F;   ///< arc length where the center line of the strip begins: before it there is a round end
    float last_px = 0.0F;    ///< and where it ends
    float half_width_px = 0.0F;  ///< at least 0.5; thinner lines are faded
    float half_dash_px = 0.0F;
    float period_px = 0.0F;  ///< dash and gap together
    Color color;
};

/// Whether painting the triangles of a stroke one over another shows.
enum class StrokeOverlap { harmless, darkens };

/// Adds `line`, enlarged by `scale`, as far as it is seen in `visible` (framebuffer pixels).
///
/// Turns are mitred where nobody can tell a mitre from a round joint, which costs 2 vertices for a point and covers no
/// pixel twice; elsewhere the strip ends with a half disc and a new one starts. Returns `darkens` when the line is
/// translucent and may cover a pixel twice: it has such sharp joints, or swings far enough around to cross itself.
StrokeOverlap append_stroke(Mesh<StrokeVertex>& mesh, const Polyline& line, const PixelBox& visible, double scale);

}  // namespace batten::render
