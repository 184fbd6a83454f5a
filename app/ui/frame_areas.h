/// How the window is divided among menu, tools, canvas, dock, inspector and status bar.
#pragma once

#include "app/editor/state/view.h"
#include "app/ui/frame.h"

namespace batten::ui {

/// Rectangles without overlap that fill the window; of no width or height where something is folded away.
struct FrameAreas {
    Rectangle window;
    Rectangle menu_bar;
    Rectangle tool_bar;
    Rectangle title_line;  ///< above the canvas
    Rectangle canvas;
    Rectangle rulers;  ///< around the canvas: their strips lie before its upper and left edge, if they are shown
    Rectangle dock;
    Rectangle cards;  ///< between canvas and inspector; while presenting they lie on the canvas
    Rectangle inspector;
    Rectangle status_bar;
};

/// The areas for a window of `size_px` at `scale` window pixels per design pixel. In a small window inspector and dock
/// give way to the canvas, and vanish before it gets too small to be of use. All edges are whole pixels.
FrameAreas arrange(glm::dvec2 size_px, const editor::View& view, double scale, bool has_cards);

/// The same areas with a title line that is as wide as canvas and cards together.
FrameAreas with_line_over_cards(FrameAreas areas);

/// The same areas with a title line of this height, in window pixels, taken from the canvas and from what else it is
/// above.
FrameAreas with_title_line(FrameAreas areas, double height_px);

/// The same areas with room for the rulers, `width_px` window pixels, taken from the canvas.
FrameAreas with_rulers(FrameAreas areas, double width_px);

}  // namespace batten::ui
