#include "app/editor/pointer/drawing.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/drawing_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/modes.h"
#include "app/editor/pointer/point_drag.h"
#include "core/make/shapes.h"
#include "core/make/through_points.h"
#include "render/camera.h"

namespace batten::editor {
namespace {

constexpr double finish_reach = 9.0;  // design pixels
constexpr int drawn_degree = 3;

/// Fewer points make no closed curve; handles make one of two.
std::size_t fewest_closed(PenMode mode) {
    return mode == PenMode::bezier ? 2 : 3;
}

std::optional<core::FitKind> fit_kind_of(PenMode mode) {
    switch (mode) {
        case PenMode::through_c2:
            return core::FitKind::c2;
        case PenMode::through_local:
            return core::FitKind::local;
        case PenMode::through_fair:
            return core::FitKind::fair;
        case PenMode::control_points:
        case PenMode::bezier:
            break;
    }
    return std::nullopt;
}

core::Vector handle_of(const DrawingCurve& drawing, std::size_t i) {
    return i < drawing.handles.size() ? drawing.handles[i] : core::Vector(0.0, 0.0);
}

// Where a piece has no handle, it leaves toward that of its other end, and as a line where there is none either.
void add_piece(std::vector<core::Point>& path, core::Point from, core::Vector ahead, core::Vector behind,
               core::Point to) {
    const core::Vector none(0.0, 0.0);
    core::Point first = from + ahead;
    core::Point second = to - behind;
    if (ahead == none) first = from + (second - from) / 3.0;
    if (behind == none) second = to + (first - to) / 3.0;
    if (ahead == none && behind == none) {
        first = from + (to - from) / 3.0;
        second = to - (to - from) / 3.0;
    }
    path.insert(path.end(), {first, second, to});
}

// The points and handles of a Bézier path through the points of the drawing.
std::vector<core::Point> bezier_points(const DrawingCurve& drawing, bool closed) {
    const std::vector<core::Point>& points = drawing.points;
    std::vector<core::Point> path{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i)
        add_piece(path, points[i - 1], handle_of(drawing, i - 1), handle_of(drawing, i), points[i]);
    if (!closed) return path;
    add_piece(path, points.back(), handle_of(drawing, points.size() - 1), handle_of(drawing, 0), points.front());
    path.pop_back();
    return path;
}

core::Result<core::Curve> curve_of(const DrawingCurve& drawing, PenMode mode, bool closed) {
    if (const auto kind = fit_kind_of(mode))
        return core::fit_points_at(drawing.points, {.kind = *kind, .closed = closed})
            .and_then([](const core::FitPoints& fit) { return core::through_points(fit); });
    if (mode == PenMode::bezier) return core::bezier_path(bezier_points(drawing, closed), closed);
    return curve_of_control_points(drawing.points, drawn_degree, closed);
}

Command command_of(const DrawingCurve& drawing, PenMode mode, bool closed) {
    if (const auto kind = fit_kind_of(mode))
        return ThroughPoints{.points = drawing.points, .kind = *kind, .closed = closed};
    if (mode == PenMode::bezier) return BezierPath{.points = bezier_points(drawing, closed), .closed = closed};
    return NewCurve{.points = drawing.points, .closed = closed};
}

bool is_pointed_at(const Gesture& gesture, core::Point point) {
    const glm::dvec2 point_px = render::screen_from_world(gesture.state.view.camera, point);
    return glm::distance(point_px, gesture.event.position_px) <= pixels(gesture.state, finish_reach);
}

bool would_close(const DrawingCurve& mode, const Gesture& gesture) {
    return mode.points.size() >= fewest_closed(gesture.state.view.pen_mode) &&
           is_pointed_at(gesture, mode.points.front());
}

/// Whether a click is on the first point while there are too few to close the curve.
bool closes_too_early(const DrawingCurve& mode, const Gesture& gesture) {
    return mode.points.size() > 1 && is_pointed_at(gesture, mode.points.front());
}

CanvasMode give_up(const Gesture& gesture) {
    gesture.queue.run(SetTool{.tool = Tool::select});
    return CanvasIdle{};
}

CanvasMode finish(DrawingCurve mode, const Gesture& gesture, bool closed) {
    if (mode.points.size() < 2) return mode;
    const PenMode pen = gesture.state.view.pen_mode;
    gesture.queue.run(command_of(mode, pen, closed));
    // What is refused is not lost: points can be taken back.
    return curve_of(mode, pen, closed) ? give_up(gesture) : CanvasMode(std::move(mode));
}

// In Bézier mode a drag draws out the handle of the first point before.
CanvasMode close(DrawingCurve mode, const Gesture& gesture) {
    if (gesture.state.view.pen_mode != PenMode::bezier) return finish(std::move(mode), gesture, true);
    mode.pulled_px = gesture.event.position_px;
    mode.first_handle = handle_of(mode, 0);
    return mode;
}

CanvasMode press_left(DrawingCurve mode, const Gesture& gesture) {
    // What is typed is about a place, whatever lies under the pointer.
    if (!is_typed(gesture)) {
        if (would_close(mode, gesture)) return close(std::move(mode), gesture);
        const bool is_double = gesture.event.action == PointerAction::double_click;
        if (is_double || is_pointed_at(gesture, mode.points.back())) return finish(std::move(mode), gesture, false);
        if (closes_too_early(mode, gesture)) {
            gesture.queue.change(ShowRefusal{"a closed curve needs three points; click one more before the first"});
            return mode;
        }
    }
    const core::Point place = pointed_at(gesture, mode.points.back());
    if (place == mode.points.back()) return mode;
    mode.points.push_back(place);
    if (gesture.state.view.pen_mode == PenMode::bezier) mode.pulled_px = gesture.event.position_px;
    return mode;
}

CanvasMode press(DrawingCurve mode, const Gesture& gesture) {
    return gesture.event.button == PointerButton::left ? press_left(std::move(mode), gesture) : CanvasMode(mode);
}

// The press that set the last point, or closes the curve at the first one, drags its handle out.
void pull_handle(DrawingCurve& mode, const Gesture& gesture) {
    mode.handles.resize(mode.points.size(), core::Vector(0.0, 0.0));
    const std::size_t i = mode.first_handle ? 0 : mode.points.size() - 1;
    const bool is_click = !is_drag(gesture.state, *mode.pulled_px, gesture.event.position_px);
    mode.handles[i] = is_click ? mode.first_handle.value_or(core::Vector(0.0, 0.0))
                               : pointed_at(gesture, mode.points[i]) - mode.points[i];
}

CanvasMode move(DrawingCurve mode, const Gesture& gesture) {
    if (mode.pulled_px) pull_handle(mode, gesture);
    mode.closes = mode.first_handle || (!mode.pulled_px && would_close(mode, gesture));
    mode.next = pointed_at(gesture, mode.points.back());
    return mode;
}

CanvasMode release(DrawingCurve mode, const Gesture& gesture) {
    if (gesture.event.button == PointerButton::right)
        return mode.points.size() < 2 ? give_up(gesture) : finish(std::move(mode), gesture, false);
    mode.pulled_px.reset();
    if (!std::exchange(mode.first_handle, std::nullopt)) return mode;
    return finish(std::move(mode), gesture, true);
}

CanvasMode take_back(DrawingCurve mode) {
    mode.points.pop_back();
    mode.pulled_px.reset();
    mode.first_handle.reset();
    mode.closes = false;
    if (mode.points.empty()) return CanvasIdle{};
    if (mode.handles.size() > mode.points.size()) mode.handles.resize(mode.points.size());
    return mode;
}

}  // namespace

DrawingCurve begin_drawing(const Gesture& gesture) {
    const core::Point position = pointed_at(gesture);
    DrawingCurve drawing{{position}, position, gesture.state.tool_changes};
    if (gesture.state.view.pen_mode == PenMode::bezier) drawing.pulled_px = gesture.event.position_px;
    return drawing;
}

CanvasMode step_drawing(DrawingCurve mode, const Gesture& gesture) {
    if (step_pan(mode.panned_px, gesture)) return mode;
    switch (gesture.event.action) {
        case PointerAction::escape:
            return give_up(gesture);
        case PointerAction::finish:
            return finish(std::move(mode), gesture, false);
        case PointerAction::take_back:
            return take_back(std::move(mode));
        case PointerAction::wheel:
            turn_canvas_wheel(gesture);
            return mode;
        case PointerAction::press:
        case PointerAction::double_click:
            return press(std::move(mode), gesture);
        case PointerAction::move:
            return move(std::move(mode), gesture);
        case PointerAction::release:
            return release(std::move(mode), gesture);
        case PointerAction::leave:
        case PointerAction::key:
            break;
    }
    return mode;
}

void keep_drawn(const DrawingCurve& drawing, PenMode mode, CommandQueue& queue) {
    if (drawing.points.size() >= 2) queue.run(command_of(drawing, mode, false));
}

std::optional<core::Curve> drawn_curve(const DrawingCurve& drawing, PenMode mode) {
    DrawingCurve all = drawing;
    const bool is_elsewhere = drawing.points.empty() || drawing.next != drawing.points.back();
    const bool takes_next = !drawing.closes && !drawing.pulled_px && is_elsewhere;
    if (takes_next) all.points.push_back(drawing.next);
    if (all.points.size() < 2) return std::nullopt;
    auto curve = curve_of(all, mode, drawing.closes);
    return curve ? std::optional(*std::move(curve)) : std::nullopt;
}

std::vector<DrawnHandle> drawn_handles(const DrawingCurve& drawing) {
    std::vector<DrawnHandle> handles;
    for (std::size_t i = 0; i < drawing.points.size(); ++i)
        if (const core::Vector handle = handle_of(drawing, i); handle != core::Vector(0.0, 0.0))
            handles.push_back({drawing.points[i] - handle, drawing.points[i] + handle});
    return handles;
}

}  // namespace batten::editor
