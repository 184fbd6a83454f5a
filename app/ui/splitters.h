/// The edges of inspector and dock, by which they are made larger and smaller.
#pragma once

#include "app/ui/frame_areas.h"
#include "app/ui/panels.h"

namespace batten::ui {

/// Draws the edges and asks for new sizes while one is dragged. A double click gives the panel its usual size.
void draw_splitters(const PanelContext& context, const FrameAreas& areas);

}  // namespace batten::ui
