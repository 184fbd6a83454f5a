#include "app/editor/pointer/canvas_press.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/fit_point_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/pointer/axis_pick.h"
#include "app/editor/pointer/drawing.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/fit_point_drag.h"
#include "app/editor/pointer/guide_mode.h"
#include "app/editor/pointer/hit_test.h"
#include "app/editor/pointer/modes.h"
#include "app/editor/pointer/picture_drag.h"
#include "app/editor/pointer/point_drag.h"
#include "app/editor/pointer/selection_press.h"
#include "app/editor/pointer/transform_box.h"
#include "app/editor/pointer/weight_modes.h"
#include "app/editor/scene/insets.h"
#include "app/editor/scene/ruler.h"

namespace batten::editor {
namespace {

constexpr double insertion_reach = 24.0;  ///< design pixels from the curve within which the insert-knot tool acts

void select_points(const Gesture& gesture, const std::vector<std::size_t>& points) {
    if (gesture.state.selection.points != points) gesture.queue.run(SelectPoints{.points = points});
}

std::vector<std::size_t> with_point(std::vector<std::size_t> points, std::size_t index) {
    points.push_back(index);
    std::sort(points.begin(), points.end());
    return points;
}

CanvasMode begin_weight_drag(const Gesture& gesture, std::size_t index) {
    select_points(gesture, {index});
    if (!may_edit_curve(gesture)) return CanvasIdle{};
    return DraggingWeight{index, committed_curve(gesture.state)->weights()[index], gesture.event.position_px};
}

CanvasMode begin_point_drag(const Gesture& gesture, std::size_t index) {
    const Selection& selection = gesture.state.selection;
    const bool was_selected = selection.contains_point(index);
    std::vector<std::size_t> points{index};
    if (was_selected)
        points = selection.points;
    else if (gesture.event.modifiers.shift)
        points = with_point(selection.points, index);
    select_points(gesture, points);
    return DraggingPoints{index, std::move(points), gesture.event.position_px, was_selected};
}

CanvasMode begin_knot_drag(const Gesture& gesture, std::size_t index) {
    gesture.queue.run(SelectKnot{.index = index});
    if (!can_edit_curve(gesture.state)) return CanvasIdle{};
    return DraggingCurveKnot{index, gesture.event.position_px};
}

/// What the select tool does to each thing that can be hit.
struct SelectPress {
    const Gesture& gesture;

    CanvasMode operator()(const HoveredParameter&) const { return DraggingParameter{gesture.state.parameter()}; }
    CanvasMode operator()(const HoveredPoint& hit) const {
        return gesture.event.modifiers.alt ? begin_weight_drag(gesture, hit.index)
                                           : begin_point_drag(gesture, hit.index);
    }
    CanvasMode operator()(const HoveredWeightRing& hit) const { return begin_weight_drag(gesture, hit.index); }
    CanvasMode operator()(const HoveredKnot& hit) const { return begin_knot_drag(gesture, hit.index); }
    CanvasMode operator()(const HoveredFarinPoint& hit) const {
        if (!may_edit_curve(gesture)) return CanvasIdle{};
        return DraggingFarinPoint{hit.leg, gesture.event.position_px};
    }
    CanvasMode operator()(const HoveredFitPoint& hit) const { return begin_fit_point_drag(gesture, hit.index); }
    CanvasMode operator()(const HoveredFitHandle& hit) const { return begin_fit_handle_drag(gesture, hit); }
    CanvasMode operator()(const HoveredCurve& hit) const {
        if (gesture.event.modifiers.shift || !can_edit_curve(gesture.state)) return begin_box(gesture);
        if (committed_fit(gesture.state) != nullptr) return begin_new_fit_point(gesture, hit.u);
        return DraggingCurvePoint{hit.u, gesture.event.position_px};
    }
    CanvasMode operator()(const HoveredHandle& hit) const {
        return DraggingHandle{start_of(gesture.state, hit.handle), gesture.event.position_px};
    }
    CanvasMode operator()(const HoveredHandlebar& hit) const { return begin_handlebar_drag(gesture, hit.part); }
    CanvasMode operator()(const HoveredGuide& hit) const { return begin_guide_drag(gesture, hit.index); }
    CanvasMode operator()(const HoveredOtherCurve& hit) const {
        gesture.queue.run(ActivateCurve{.index = hit.index});
        return CanvasIdle{};
    }
    CanvasMode operator()(const HoveredNothing&) const {
        const auto picture = picture_at(gesture.state, gesture.event.position_px);
        if (!picture || gesture.event.modifiers.shift) return begin_box(gesture);
        return DraggingPicture{*picture, gesture.event.position_px};
    }
    template <class Other>
    CanvasMode operator()(const Other&) const {
        return begin_box(gesture);
    }
};

/// What a double click of the select tool does.
struct SelectDoubleClick {
    const Gesture& gesture;

    void operator()(const HoveredCurve& hit) const { insert_knot(hit.u); }
    void operator()(const HoveredParameter&) const { insert_knot(gesture.state.parameter()); }
    void operator()(const HoveredHandlebar&) const { insert_knot(*gesture.state.selection.handlebar); }
    void operator()(const HoveredFitPoint& hit) const { turn_fit_joint(gesture, hit.index); }
    void operator()(const HoveredKnot& hit) const { gesture.queue.run(RaiseKnot{.index = hit.index}); }
    void operator()(const HoveredLeg& hit) const {
        const core::Point position = pointed_at(gesture);
        gesture.queue.run(AddPoint{.index = hit.index + 1, .position = position});
    }
    template <class Other>
    void operator()(const Other&) const {}

  private:
    void insert_knot(double u) const {
        if (committed_fit(gesture.state) != nullptr)
            insert_fit_point_at(gesture, u);
        else
            gesture.queue.run(InsertKnot{.u = u});
    }
};

/// Whether it does anything that a press does not.
bool takes_double_click(const Hover& hit) {
    if (const auto* bar = std::get_if<HoveredHandlebar>(&hit)) return bar->part == HandlebarPart::middle;
    return std::holds_alternative<HoveredCurve>(hit) || std::holds_alternative<HoveredParameter>(hit) ||
           std::holds_alternative<HoveredFitPoint>(hit) || std::holds_alternative<HoveredKnot>(hit) ||
           std::holds_alternative<HoveredLeg>(hit);
}

std::optional<std::size_t> point_of(const Hover& hit) {
    if (const auto* point = std::get_if<HoveredPoint>(&hit)) return point->index;
    if (const auto* ring = std::get_if<HoveredWeightRing>(&hit)) return ring->index;
    return std::nullopt;
}

CanvasMode press_select(const Gesture& gesture, const Hover& hit) {
    const bool is_double = gesture.event.action == PointerAction::double_click;
    if (is_double && takes_double_click(hit)) return DoubleClicking{gesture.event};
    if (auto mode = press_over_curves(gesture, hit)) return *std::move(mode);
    return std::visit(SelectPress{gesture}, hit);
}

CanvasMode press_weight(const Gesture& gesture, const Hover& hit) {
    if (const auto index = point_of(hit)) return begin_weight_drag(gesture, *index);
    return begin_box(gesture);
}

CanvasMode press_add_point(const Gesture& gesture, const Hover& hit) {
    if (const auto* point = std::get_if<HoveredPoint>(&hit)) return begin_point_drag(gesture, point->index);
    if (!may_edit_curve(gesture)) return CanvasIdle{};
    const core::Point position = pointed_at(gesture);
    if (const core::FitPoints* fit = committed_fit(gesture.state)) {
        gesture.queue.run(InsertFitPoint{.index = best_index_for(*fit, position), .position = position});
        return CanvasIdle{};
    }
    gesture.queue.run(
        AddPoint{.index = best_index_for(*committed_curve(gesture.state), position), .position = position});
    return CanvasIdle{};
}

CanvasMode press_insert_knot(const Gesture& gesture, const Hover& hit) {
    if (!may_edit_curve(gesture)) return CanvasIdle{};
    if (const auto* knot = std::get_if<HoveredKnot>(&hit)) {
        gesture.queue.run(RaiseKnot{.index = knot->index});
        return CanvasIdle{};
    }
    const render::Camera& camera = gesture.state.view.camera;
    const glm::dvec2 pointer = gesture.event.position_px;
    const core::CurveSample sample = nearest_to_pointer(gesture);
    const double distance = glm::distance(pointer, render::screen_from_world(camera, sample.point));
    if (distance <= pixels(gesture.state, insertion_reach)) gesture.queue.run(InsertKnot{.u = sample.u});
    return CanvasIdle{};
}

/// The grips of the box; a control point in it moves all, unless Shift takes it in or out.
CanvasMode press_transform(const Gesture& gesture, const Hover& hit) {
    const auto grip = is_typed(gesture) ? std::nullopt : grip_at(gesture.state, gesture.event.position_px);
    const bool is_inside = grip && grip->kind == GripKind::inside;
    const auto* point = std::get_if<HoveredPoint>(&hit);
    const bool selects =
        gesture.event.modifiers.shift || (point == nullptr && is_selected_by_press(gesture.state, hit));
    if (!grip || (is_inside && selects)) return press_select(gesture, hit);
    return begin_transform(gesture, *grip, is_inside && point != nullptr ? std::optional(point->index) : std::nullopt);
}

CanvasMode press_parameter(const Gesture& gesture) {
    if (committed_curve(gesture.state) == nullptr) return CanvasIdle{};
    gesture.queue.run(SetParameter{.u = nearest_to_pointer(gesture).u});
    return DraggingParameter{gesture.state.parameter()};
}

std::size_t index_near_leg(std::span<const core::Point> points, bool closed, core::Point position) {
    const std::size_t n = points.size();
    const auto detour = [&](core::Point a, core::Point b) {
        return distance(a, position) + distance(position, b) - distance(a, b);
    };
    std::size_t best = n;
    double least = closed ? detour(points[n - 1], points[0]) : distance(points[n - 1], position);
    const auto offer = [&](std::size_t index, double growth) {
        if (growth < least) {
            least = growth;
            best = index;
        }
    };
    if (!closed) offer(0, distance(points[0], position));
    for (std::size_t i = 1; i < n; ++i) offer(i, detour(points[i - 1], points[i]));
    return best;
}

}  // namespace

std::size_t best_index_for(const core::Curve& curve, core::Point position) {
    return index_near_leg(curve.control_points(), curve.is_periodic(), position);
}

std::size_t best_index_for(const core::FitPoints& fit, core::Point position) {
    std::vector<core::Point> places;
    for (const core::FitPoint& point : fit.points) places.push_back(point.place);
    return index_near_leg(places, fit.closed, position);
}

CanvasMode step(const DoubleClicking& mode, const Gesture& gesture) {
    if (is_escape(gesture)) return CanvasIdle{};
    if (!is_move(gesture) && !is_release(gesture)) return mode;
    PointerEvent press = mode.press;
    press.action = PointerAction::press;
    const Gesture pressed{press, gesture.state, gesture.queue, gesture.typed, gesture.place};
    if (is_drag(gesture.state, press.position_px, gesture.event.position_px))
        return step_mode(begin_canvas_gesture(pressed), gesture);
    if (!is_release(gesture)) return mode;
    std::visit(SelectDoubleClick{pressed}, hit_canvas(gesture.state, press.position_px));
    return CanvasIdle{};
}

bool is_about_tool(const Gesture& gesture) {
    const glm::dvec2 place = gesture.event.position_px;
    const bool is_covered = ruler_at(gesture.state, place) || inset_at(gesture.state, place);
    return !is_covered && !is_gauging(gesture.state) && !gesture.state.axis_pick;
}

CanvasMode begin_canvas_gesture(const Gesture& gesture) {
    if (is_pan(gesture.event)) return Panning{gesture.event.position_px};
    if (gesture.event.button != PointerButton::left) return CanvasIdle{};
    if (ruler_at(gesture.state, gesture.event.position_px) && !is_typed(gesture)) return begin_ruler_gesture(gesture);
    if (is_gauging(gesture.state)) {
        gesture.queue.change(AddGaugePoint{pointed_at(gesture)});
        return CanvasIdle{};
    }
    if (gesture.state.axis_pick) {
        click_axis(gesture);
        return CanvasIdle{};
    }
    if (inset_at(gesture.state, gesture.event.position_px)) return begin_inset_gesture(gesture);
    // What is typed is about a place, whatever lies under the pointer.
    const Hover hit =
        is_typed(gesture) ? Hover(HoveredNothing{}) : hit_canvas(gesture.state, gesture.event.position_px);
    switch (gesture.state.tool) {
        case Tool::select:
            return press_select(gesture, hit);
        case Tool::add_point:
            return press_add_point(gesture, hit);
        case Tool::insert_knot:
            return press_insert_knot(gesture, hit);
        case Tool::weight:
            return press_weight(gesture, hit);
        case Tool::draw_curve:
            return begin_drawing(gesture);
        case Tool::parameter:
            return press_parameter(gesture);
        case Tool::shape:
            return begin_shape(gesture);
        case Tool::pencil:
            return begin_stroke(gesture);
        case Tool::joint:
            return begin_joint(gesture);
        case Tool::brush:
            return begin_brush(gesture);
        case Tool::transform:
            return press_transform(gesture, hit);
    }
    return CanvasIdle{};
}

}  // namespace batten::editor
