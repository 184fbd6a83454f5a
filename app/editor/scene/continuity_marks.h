/// The derivatives on both sides of a joint, on the canvas.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// At the joint that the continuity meter points at, where the ends meet and where other curves are met: C' before the
/// joint as an arrow that arrives there, C' behind it as one that leaves, so that a smooth joint is straight and one
/// that is C1 is halved by it; C'' on both sides, thinner and dashed; the verdict; across a gap a dashed line. Arrows
/// are as long as legs, shorter where they would leave the picture. The frame must have a curve.
void draw_continuity_marks(CanvasFrame& frame);

}  // namespace batten::editor
