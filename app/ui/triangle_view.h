/// The triangle of the de Boor algorithm as cells joined by lines.
#pragma once

#include "app/ui/panels.h"
#include "core/evaluate/de_boor.h"

namespace batten::ui {

/// Draws the triangle at the cursor, `width_px` wide; what does not fit scrolls in a region of bounded height. Levels
/// after `last_level` are faded. A hovered cell is wished for as the hover; every cell in sight reports its place as
/// "cell r j".
void draw_triangle(const PanelContext& context, const core::Curve& curve, const core::DeBoorTriangle& triangle,
                   std::size_t last_level, float width_px);

}  // namespace batten::ui
