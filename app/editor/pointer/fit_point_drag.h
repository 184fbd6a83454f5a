/// What a press on fit points, their handles and the curve through them begins, and how they are dragged.
#pragma once

#include <optional>

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/gesture.h"
#include "core/make/fit_points.h"

namespace batten::editor {

/// The fit points of the committed active curve; null where it is not made of such.
const core::FitPoints* committed_fit(const EditorState& state);

/// Where an end of the handle of point `i` is.
core::Point handle_tip(const core::FitPoints& fit, std::size_t i, HandleEnd end);

/// Which points show their handles: those with a given tangent, of a long curve only the selected one.
std::vector<std::size_t> points_with_handles(const core::FitPoints& fit, const Selection& selection);

/// The number that a point put in at the parameter `u` of the curve has.
std::size_t index_of_new_point(const core::FitPoints& fit, double u);

/// The number of the fit point at exactly the parameter `u`; none where there is none.
std::optional<std::size_t> fit_point_at(const core::FitPoints& fit, double u);

CanvasMode begin_fit_point_drag(const Gesture& gesture, std::size_t index);
CanvasMode begin_fit_handle_drag(const Gesture& gesture, const HoveredFitHandle& hit);

/// A drag of the curve at `u` pulls out a new point.
CanvasMode begin_new_fit_point(const Gesture& gesture, double u);

/// What a double click on the curve at `u`, or on a fit point, does: puts in a point there; makes a corner of a smooth
/// point, and a smooth one of any other.
void insert_fit_point_at(const Gesture& gesture, double u);
void turn_fit_joint(const Gesture& gesture, std::size_t index);

CanvasMode step_fit_point_drag(const DraggingFitPoint& mode, const Gesture& gesture);
CanvasMode step_fit_handle_drag(const DraggingFitHandle& mode, const Gesture& gesture);

}  // namespace batten::editor
