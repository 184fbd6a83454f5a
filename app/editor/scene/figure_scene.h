/// Figures for slides and papers: the pictures of the window, without what only a window needs.
#pragma once

#include "app/editor/derived/cut_polygon.h"
#include "app/editor/scene/label_spots.h"
#include "app/editor/state/state.h"
#include "render/figure.h"

namespace batten::editor {

/// What the canvas of the window shows now, with its camera; with FigureView::both or basis the plot as high as the
/// dock. Without pointer, selection and what tells how many marks are left out. On a page of another size the same part
/// of the plane is seen, or more of it.
render::Figure window_figure(const EditorState& state, const FigureForm& form);

/// How large that is at a scale of 1 without a title, in design pixels.
glm::dvec2 window_figure_size(const EditorState& state, FigureView view);

/// The least height, before form.scale, of a page of that width on which the plots of the view can be read, and the
/// title, a whole number; 0 where there are no plots.
double least_figure_height(const View& view, const FigureForm& form, double width_px);

/// Prepares a state for a page of `size_px` (> 0, before form.scale) with the overlays and parts of its view: at rest,
/// and with the camera that shows the visible curves as large as they fit.
void pose_for_figure(EditorState& state, const FigureForm& form, glm::dvec2 size_px);

/// The page of a state that was prepared for it.
render::Figure figure_of(const EditorState& posed, const FigureForm& form, glm::dvec2 size_px);

/// A frame of an animation. In place of the control polygon of the curve, which has the knot that
/// comes in, `moving` is drawn over it where it has corners. Labels stay where `spots` tells that they stood, as long
/// as they have room there, and `spots` tells afterward where they stand.
render::Figure figure_of(const EditorState& posed, const FigureForm& form, glm::dvec2 size_px,
                         const MovingPolygon& moving, LabelSpots& spots);

}  // namespace batten::editor
