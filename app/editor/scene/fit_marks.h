/// The points that a curve is made to pass, and the handles of given tangents.
#pragma once

#include "app/editor/scene/canvas_frame.h"
#include "core/make/fit_points.h"

namespace batten::editor {

inline constexpr double fit_point_radius = 5.5;  ///< design pixels, half the side of a square

/// The fit points of the shown active curve; null where it is hidden or not made of such.
const core::FitPoints* shown_fit(const CanvasFrame& frame);

/// Squares for the points that are seen, smaller and then fewer where they crowd: hollow where the curve is smooth,
/// full where it is not; and the handles.
void draw_fit_marks(CanvasFrame& frame);

/// A handle from one of its ends to the other.
void draw_fit_handle(CanvasFrame& frame, glm::dvec2 behind, glm::dvec2 ahead, bool is_lit);

}  // namespace batten::editor
