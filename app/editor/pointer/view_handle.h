/// The handles of the teaching views on the canvas.
#pragma once

#include <optional>

#include "app/editor/pointer/gesture.h"
#include "app/editor/state/probe_line.h"
#include "app/editor/state/selection.h"

namespace batten::editor {

/// The line whose crossings are shown; none without its view or a curve.
std::optional<ProbeLine> shown_probe_line(const EditorState& state);

/// The handle under `position_px`, a place of the canvas: the ends of the line and that of the comb (within 9 design
/// pixels), nearest first. Only for the select tool.
std::optional<ViewHandle> handle_at(const EditorState& state, glm::dvec2 position_px);

/// Whether the line itself (5) is there.
bool is_on_probe_line(const EditorState& state, glm::dvec2 position_px);

/// What a drag of a handle began with.
struct HandleStart {
    ViewHandle handle = ViewHandle::comb;
    double comb_factor = 1.0;
    ProbeLine line;
};

/// What the view has now, for a drag of `handle` to begin with.
HandleStart start_of(const EditorState& state, ViewHandle handle);

/// Asks for what the handle dragged from `press_px` to the pointer means. Ctrl snaps the ends of the line to the grid,
/// Shift keeps to one axis.
void drag_handle(const HandleStart& start, const Gesture& gesture, glm::dvec2 press_px);

/// Asks for what was there when the drag began.
void restore_handle(const HandleStart& start, const Gesture& gesture);

}  // namespace batten::editor
