/// The curvature comb: teeth across the curve, as long as its curvature, and the line through their tips.
#pragma once

#include "app/editor/scene/crowd.h"

namespace batten::editor {

/// Teeth point away from the center of curvature, so they change sides at inflections. The comb breaks at knots, where
/// both one-sided values are drawn, and is missing where the curve stands still. Lengths are relative to what is large
/// along this curve, so zooming and panning do not change them. Where spans are too many, some have one tooth; returns
/// how many spans of how many have teeth.
Thinned draw_curvature_comb(CanvasFrame& frame);

/// The tooth at the view's parameter and the handle at its tip that makes the comb longer or shorter.
void draw_comb_handle(CanvasFrame& frame);

}  // namespace batten::editor
