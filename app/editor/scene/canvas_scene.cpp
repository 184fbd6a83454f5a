#include "app/editor/scene/canvas_scene.h"

#include "app/editor/cards/floating_cards.h"
#include "app/editor/scene/bezier_polygons.h"
#include "app/editor/scene/canvas_frame.h"
#include "app/editor/scene/canvas_labels.h"
#include "app/editor/scene/construction.h"
#include "app/editor/scene/control_points.h"
#include "app/editor/scene/control_polygon.h"
#include "app/editor/scene/crowd_note.h"
#include "app/editor/scene/curvature_comb.h"
#include "app/editor/scene/curve_knots.h"
#include "app/editor/scene/curve_strokes.h"
#include "app/editor/scene/directions.h"
#include "app/editor/scene/filled_shapes.h"
#include "app/editor/scene/finding_marks.h"
#include "app/editor/scene/fit_marks.h"
#include "app/editor/scene/gesture_marks.h"
#include "app/editor/scene/grid.h"
#include "app/editor/scene/handlebar_marks.h"
#include "app/editor/scene/insets.h"
#include "app/editor/scene/legend.h"
#include "app/editor/scene/marked_joints.h"
#include "app/editor/scene/moving_polygon.h"
#include "app/editor/scene/other_curves.h"
#include "app/editor/scene/pictures.h"
#include "app/editor/scene/place_marks.h"
#include "app/editor/scene/selection_marks.h"
#include "app/editor/scene/sketch_scene.h"
#include "app/editor/scene/span_hulls.h"
#include "app/editor/scene/transform_marks.h"
#include "app/editor/scene/views.h"

namespace batten::editor {

namespace {

/// Returns what labels must keep clear of: the numbers of the grid, legend, insets and cards, and the marks of
/// findings.
std::vector<render::PixelBox> draw_background(CanvasFrame& frame) {
    std::vector<render::PixelBox> covered;
    const auto legend = shows_legend(frame.state)
                            ? std::optional(legend_box(frame.state, frame.state.view.legend_corner))
                            : std::nullopt;
    if (frame.shows(Overlay::grid)) draw_grid(frame);
    // A figure has no rulers around it.
    const bool has_rulers = frame.shows(Overlay::rulers) && !frame.state.view.parts.window;
    if (frame.shows(Overlay::grid) || has_rulers) covered = draw_grid_numbers(frame, legend);
    if (legend) covered.push_back(*legend);
    for (const InsetPlace& inset : inset_places(frame.state)) covered.push_back(inset.box);
    if (const auto cards = floating_cards_box(frame.state)) covered.push_back(*cards);
    for (const render::PixelBox& box : finding_boxes(frame)) covered.push_back(box);
    draw_filled_shapes(frame);
    draw_guides(frame);
    reserve_transform_box(frame);
    draw_ghost(frame);
    draw_selected_others(frame);
    draw_other_curves(frame);
    draw_other_points(frame);
    return covered;
}

/// Without a polygon that moves, so that labels stay where they are.
CanvasMarks marks_of(const CanvasFrame& frame, const MovingPolygon& moving) {
    CanvasMarks marks;
    marks.points = shown_points(frame);
    marks.knots = shown_knots(frame, marks.points);
    if (frame.shows(Overlay::polygon) && moving.corners.empty()) marks.polygon = polygon_line(frame);
    return marks;
}

/// Notes the lines that were drawn from the command `first` on, and symbols like short ones, for labels to stay off.
void note_lines(CanvasFrame& frame, const render::DrawList& list, std::size_t first) {
    for (std::size_t k = first; k < list.commands.size(); ++k) {
        if (const auto* line = std::get_if<render::Polyline>(&list.commands[k])) {
            frame.lines.emplace_back(line->points.begin(), line->points.end());
            if (line->is_closed) frame.lines.back().emplace_back(line->points.front());
        }
        if (const auto* marker = std::get_if<render::Marker>(&list.commands[k])) {
            const glm::dvec2 center(marker->center);
            const glm::dvec2 along(marker->radius_px, 0.0);
            frame.lines.push_back({center - along, center + along});
        }
    }
}

/// None where they are left out, the dense ones where they move.
ShownPoints points_to_draw(const CanvasFrame& frame, const ShownPoints& points, const MovingPolygon& moving) {
    if (!frame.state.view.parts.points) return {};
    if (moving.corners.empty()) return points;
    ShownPoints dense = moved_points(frame, points, moving);
    dense.large.clear();
    return dense;
}

void draw_lines_of_active_curve(CanvasFrame& frame, const render::DrawList& list, CanvasMarks& marks,
                                const ShownPoints& points, const MovingPolygon& moving) {
    draw_hull(frame);
    if (moving.corners.empty())
        draw_control_polygon(frame, marks.polygon);
    else if (frame.shows(Overlay::polygon))
        draw_moving_line(frame, moving);
    draw_dense_points(frame, points);
    const std::size_t first = list.commands.size();
    if (frame.shows(Overlay::bezier_pieces)) marks.pieces = draw_bezier_pieces(frame);
    if (frame.shows(Overlay::curvature_comb)) marks.comb_spans = draw_curvature_comb(frame);
    if (frame.shows(Overlay::span_hulls)) marks.hulls = draw_span_hulls(frame);
    draw_views_below(frame);
    note_lines(frame, list, first);
    draw_selected_active(frame);
    draw_lit_parts(frame);
    draw_active_curve(frame);
}

void draw_marks_of_active_curve(CanvasFrame& frame, const render::DrawList& list, const CanvasMarks& marks,
                                const std::vector<render::PixelBox>& covered, const ShownPoints& points) {
    draw_curve_knots(frame, marks.knots);
    draw_marked_joints(frame);
    draw_hovered_place(frame);
    const std::size_t first = list.commands.size();
    if (frame.shows(Overlay::construction)) draw_construction(frame);
    draw_control_points(frame, points);
    if (frame.state.view.parts.points) draw_fit_marks(frame);
    draw_handlebar(frame);
    draw_views_above(frame);
    note_lines(frame, list, first);
    if (frame.state.view.parts.parameter) draw_curve_point(frame);
    draw_canvas_labels(frame, marks, covered);
}

render::DrawList scene_with(const EditorState& state, const CanvasMode& mode, const MovingPolygon& moving,
                            SceneCache& cache) {
    if (has_sketch(state)) return sketch_scene(state);
    render::DrawList list;
    CanvasFrame frame(state, cache, list);
    draw_pictures(frame, list);
    std::vector<render::PixelBox> covered = draw_background(frame);
    std::vector<CrowdNote> notes;
    if (frame.curve != nullptr) {
        CanvasMarks marks = marks_of(frame, moving);
        const ShownPoints points = points_to_draw(frame, marks.points, moving);
        draw_lines_of_active_curve(frame, list, marks, points, moving);
        if (state.view.parts.window)
            notes = crowd_notes(frame, marks);
        else
            cache.thinned() = thinned_texts(frame, marks, points);
        for (const CrowdNote& note : notes) covered.push_back(note.box);
        draw_marks_of_active_curve(frame, list, marks, covered, points);
    }
    if (frame.shows(Overlay::directions)) draw_directions(frame);
    draw_finding_marks(frame);
    if (shows_legend(state)) draw_legend(frame);
    draw_transform_box(frame, mode);
    draw_gesture_marks(frame, mode);
    draw_axis_pick(frame);
    draw_picture_gauge(frame);
    if (frame.curve != nullptr) draw_insets(frame);
    draw_crowd_notes(frame, notes);
    draw_place(frame);
    return list;
}

}  // namespace

render::DrawList canvas_scene(const EditorState& state, const CanvasMode& mode, SceneCache& cache) {
    return scene_with(state, mode, {}, cache);
}

render::DrawList canvas_scene_around(const MovingPolygon& moving, const EditorState& state, SceneCache& cache) {
    return scene_with(state, CanvasIdle{}, moving, cache);
}

}  // namespace batten::editor
