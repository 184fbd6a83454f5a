/// What of the document is under the pointer.
#pragma once

#include "app/editor/pointer/plot_layout.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// What lies under `position_px` of the canvas, nearest of the most specific kind first: the handlebar (within 9 design
/// pixels), C(u) and control points (9; the point where both are equally near; shown ones of other curves after other
/// small things), handles of teaching views (9), weight rings (4 to both sides), Farin points (8), knots (8; the
/// topmost stands for its stack), points of the construction (7), the curve (6), the line of a view (5), polygon legs
/// (5), other curves (6), guides (5). Rulers and insets hide what is below them. Hidden overlays cannot be hit, nor can
/// invisible curves. Parts of a locked curve can: they light up, and an edit of them is refused with its reason. The
/// distance to curves is exact at any zoom; they cost nothing while the pointer is far from their control points.
Hover hit_canvas(const EditorState& state, glm::dvec2 position_px);

/// What lies under `position_px` of the dock: on the strip knots (within 8 design pixels, the topmost stands for its
/// stack), then the line at u (5), then graphs (6), and on the strip the span.
Hover hit_plot(const EditorState& state, const PlotLayout& layout, glm::dvec2 position_px);

}  // namespace batten::editor
