#include "app/editor/scene/gesture_marks.h"

#include <algorithm>

#include "core/curve/knot_kinds.h"

namespace batten::editor {

namespace {

constexpr int drawn_degree = 3;

/// The curve that would come of `points`: clamped uniform, of a lower degree while points are few.
core::Result<core::Curve> drawn_curve(const std::vector<core::Point>& points) {
    const int degree = std::min(drawn_degree, static_cast<int>(points.size()) - 1);
    return core::make_knots(core::KnotKind::clamped_uniform, degree, points.size())
        .and_then([&](core::KnotVector knots) { return core::Curve::make(std::move(knots), points, {}); });
}

/// Draws what belongs to the mode; nothing for most of them.
struct MarksOf {
    CanvasFrame& frame;

    void operator()(const BoxSelecting& box) const {
        const std::vector<glm::dvec2> corners = corners_of(render::PixelBox::between(box.press_px, box.position_px));
        frame.pen.fill(corners, render::faded(frame.theme.accent, 0.12));
        frame.pen.outline(corners, {.color = frame.theme.accent});
    }

    void operator()(const DrawingCurve& drawing) const {
        std::vector<core::Point> points = drawing.points;
        points.push_back(drawing.next);
        const std::vector<glm::dvec2> places = frame.screen(points);
        frame.pen.line(places, {.color = frame.theme.polygon, .width = 1.5, .dash = 6.0, .gap = 5.0});
        if (points.size() > 1)
            if (const auto curve = drawn_curve(points)) draw_shape(*curve);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const bool is_next = i + 1 == places.size();
            frame.pen.symbol(places[i], {.radius = 6.5,
                                         .fill = is_next ? frame.theme.canvas : frame.theme.point(i),
                                         .outline = is_next ? frame.theme.point(i) : frame.theme.canvas,
                                         .outline_width = 2.0});
        }
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

    template <class Other>
    void operator()(const Other&) const {}
};

}  // namespace

void draw_gesture_marks(CanvasFrame& frame, const CanvasMode& mode) {
    std::visit(MarksOf{frame}, mode);
}

}  // namespace batten::editor
