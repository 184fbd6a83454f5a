#include "app/editor/scene/gesture_marks.h"

#include <algorithm>

#include "app/editor/pointer/drawing.h"
#include "app/editor/scene/brush_marks.h"
#include "app/editor/scene/fit_marks.h"
#include "app/editor/scene/joint_tool_marks.h"

namespace batten::editor {

namespace {

/// Draws what belongs to the mode; nothing for most of them.
struct MarksOf {
    CanvasFrame& frame;

    void operator()(const BoxSelecting& box) const {
        const std::vector<glm::dvec2> corners = corners_of(render::PixelBox::between(box.press_px, box.position_px));
        frame.pen.fill(corners, render::faded(frame.theme.accent, 0.12));
        frame.pen.outline(corners, {.color = frame.theme.accent});
    }

    void operator()(const DrawingCurve& drawing) const {
        const PenMode pen_mode = frame.state.view.pen_mode;
        std::vector<core::Point> points = drawing.points;
        if (!drawing.pulled_px) points.push_back(drawing.closes ? drawing.points.front() : drawing.next);
        const std::vector<glm::dvec2> places = frame.screen(points);
        if (pen_mode == PenMode::control_points)
            frame.pen.line(places, {.color = frame.theme.polygon, .width = 1.5, .dash = 6.0, .gap = 5.0});
        if (const auto curve = drawn_curve(drawing, pen_mode)) draw_shape(*curve);
        if (pen_mode == PenMode::bezier) draw_handles(drawing);
        for (std::size_t i = 0; i < places.size(); ++i) draw_drawn_point(drawing, places[i], i);
    }

    void draw_handles(const DrawingCurve& drawing) const {
        for (const DrawnHandle& handle : drawn_handles(drawing))
            draw_fit_handle(frame, frame.screen(handle.behind), frame.screen(handle.ahead), false);
    }

    // Control points are discs, points that the curve passes are squares; the first is marked where a click closes.
    void draw_drawn_point(const DrawingCurve& drawing, glm::dvec2 place, std::size_t i) const {
        const bool is_control = frame.state.view.pen_mode == PenMode::control_points;
        const bool is_next = i == drawing.points.size();
        const render::Color color = is_control ? frame.theme.point(i) : frame.theme.curve;
        if (drawing.closes && is_next) {
            frame.pen.symbol(place,
                             {.radius = 11.0, .fill = no_color, .outline = frame.theme.accent, .outline_width = 2.0});
            return;
        }
        frame.pen.symbol(place, {.shape = is_control ? render::MarkerShape::disc : render::MarkerShape::square,
                                 .radius = is_control ? 6.5 : fit_point_radius,
                                 .fill = is_next ? frame.theme.canvas : color,
                                 .outline = is_next ? color : frame.theme.canvas,
                                 .outline_width = 2.0});
    }

    void operator()(const PencilStroke& stroke) const {
        std::vector<core::Point> line = stroke.settled;
        line.insert(line.end(), stroke.line.begin(), stroke.line.end());
        if (line.size() > 1) frame.pen.line(frame.screen(line), {.color = frame.theme.accent, .width = 3.0});
    }

    void draw_shape(const core::Curve& curve) const {
        KeptCurve kept(std::make_shared<const core::Curve>(curve));
        const Stroke stroke{.color = frame.theme.accent, .width = 3.0};
        draw_line(frame, seen_curve(frame, kept, stroke), stroke);
    }

    void operator()(const DrawingShape& drawing) const {
        std::vector<core::Point> points = drawing.points;
        points.push_back(drawing.next);
        const std::vector<glm::dvec2> places = frame.screen(points);
        frame.pen.line(places, {.color = frame.theme.polygon, .width = 1.5, .dash = 6.0, .gap = 5.0});
        for (const glm::dvec2 place : places)
            frame.pen.symbol(
                place,
                {.radius = 4.0, .fill = frame.theme.canvas, .outline = frame.theme.accent, .outline_width = 2.0});
    }

    void operator()(const Brushing& mode) const { draw_brush(frame, mode); }
    void operator()(const PickingJoint& mode) const { draw_picked_joint(frame, mode); }

    template <class Other>
    void operator()(const Other&) const {}
};

}  // namespace

void draw_gesture_marks(CanvasFrame& frame, const CanvasMode& mode) {
    std::visit(MarksOf{frame}, mode);
}

}  // namespace batten::editor
