/// Pointer modes of the dock with the basis plot and the knot strip.
#pragma once

#include <string>
#include <variant>

#include "app/editor/command.h"
#include "app/editor/pointer/plot_layout.h"
#include "app/editor/pointer/pointer.h"
#include "app/editor/state/state.h"

namespace batten::editor {

struct PlotIdle {};

/// A knot follows the pointer, in the mode that the view names: stop, push or snap (onto knots within 8 design pixels).
/// Ctrl keeps to round numbers.
struct DraggingKnot {
    std::size_t index = 0;      ///< in stored() of the committed curve
    double press_offset = 0.0;  ///< the knot less the parameter under the pointer when it was pressed
    double press_x_px = 0.0;
    bool has_moved = false;
};

/// The line at u follows the pointer.
struct DraggingPlotParameter {
    double start = 0.0;
};

struct PanningPlot {
    double last_x_px = 0.0;
};

/// The second press of a double click, which does what it does when it is released. A drag is that of a single press.
struct DoubleClickingPlot {
    PointerEvent press;
};

using PlotMode = std::variant<PlotIdle, DraggingKnot, DraggingPlotParameter, PanningPlot, DoubleClickingPlot>;

/// The mode after `event` on a dock of `size_px`; what it asks of the editor goes to `queue`. Pure: depends on its
/// arguments only.
PlotMode step_plot(const PlotMode& mode, const PointerEvent& event, const EditorState& state, glm::dvec2 size_px,
                   CommandQueue& queue);

/// What a click or drag would do here, for the status bar.
std::string plot_hint(const PlotMode& mode, const EditorState& state);

}  // namespace batten::editor
