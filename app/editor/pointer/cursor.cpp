#include "app/editor/pointer/cursor.h"

namespace batten::editor {

namespace {

template <class... Things>
bool is_one_of(const Hover& hover) {
    return (std::holds_alternative<Things>(hover) || ...);
}

// What the select tool does to the thing under the pointer.
Cursor select_cursor(const EditorState& state) {
    if (is_one_of<HoveredPoint, HoveredHandle, HoveredFitPoint, HoveredFitHandle, HoveredGuide, HoveredOtherPoint,
                  HoveredHandlebar, HoveredPicture>(state.hover))
        return Cursor::move;
    if (is_one_of<HoveredWeightRing>(state.hover)) return Cursor::vertical;
    const bool is_grip =
        is_one_of<HoveredParameter, HoveredKnot, HoveredCurve, HoveredOtherCurve, HoveredFarinPoint, HoveredLifted>(
            state.hover);
    return is_grip ? Cursor::hand : Cursor::arrow;
}

/// The arrow that is nearest to the direction in which the grip is dragged.
Cursor grip_cursor(TransformGrip grip) {
    switch (grip.kind) {
        case GripKind::scale:
            return grip.x == 0 ? Cursor::vertical : grip.y == 0 ? Cursor::horizontal : Cursor::move;
        case GripKind::shear:
            return grip.x == 0 ? Cursor::horizontal : Cursor::vertical;
        case GripKind::turn:
            return Cursor::hand;
        case GripKind::inside:
        case GripKind::pivot:
            break;
    }
    return Cursor::move;
}

Cursor tool_cursor(const EditorState& state) {
    if (const auto* ruler = std::get_if<HoveredRuler>(&state.hover))
        return ruler->axis == RulerAxis::x ? Cursor::vertical : Cursor::horizontal;
    if (const auto* hovered = std::get_if<HoveredGrip>(&state.hover)) return grip_cursor(hovered->grip);
    const bool is_on_point = is_one_of<HoveredPoint, HoveredWeightRing>(state.hover);
    switch (state.tool) {
        case Tool::select:
        case Tool::transform:
            return select_cursor(state);
        case Tool::add_point:
            return is_one_of<HoveredPoint>(state.hover) ? Cursor::move : Cursor::crosshair;
        case Tool::weight:
            return is_on_point ? Cursor::vertical : Cursor::crosshair;
        case Tool::parameter:
            return Cursor::hand;
        case Tool::insert_knot:
        case Tool::draw_curve:
        case Tool::shape:
        case Tool::pencil:
        case Tool::joint:
        case Tool::brush:
            break;
    }
    return Cursor::crosshair;
}

// One case for each mode of the canvas.
struct CanvasCursor {
    const EditorState& state;

    Cursor operator()(const CanvasIdle&) const { return tool_cursor(state); }
    Cursor operator()(const DoubleClicking&) const { return tool_cursor(state); }
    Cursor operator()(const DraggingPoints&) const { return Cursor::move; }
    Cursor operator()(const DraggingCurvePoint&) const { return Cursor::move; }
    Cursor operator()(const DraggingFitPoint&) const { return Cursor::move; }
    Cursor operator()(const DraggingFitHandle&) const { return Cursor::move; }
    Cursor operator()(const Panning&) const { return Cursor::move; }
    Cursor operator()(const DraggingHandle&) const { return Cursor::move; }
    Cursor operator()(const DraggingWeight&) const { return Cursor::vertical; }
    Cursor operator()(const BoxSelecting&) const { return Cursor::crosshair; }
    Cursor operator()(const DrawingCurve& mode) const { return mode.panned_px ? Cursor::move : Cursor::crosshair; }
    Cursor operator()(const PencilStroke&) const { return Cursor::crosshair; }
    Cursor operator()(const DraggingParameter&) const { return Cursor::hand; }
    Cursor operator()(const DraggingCurveKnot&) const { return Cursor::hand; }
    Cursor operator()(const DraggingFarinPoint&) const { return Cursor::hand; }
    Cursor operator()(const DraggingLiftedWeight&) const { return Cursor::hand; }
    Cursor operator()(const TurningOrbit&) const { return Cursor::hand; }
    Cursor operator()(const DrawingShape&) const { return Cursor::crosshair; }
    Cursor operator()(const PickingJoint&) const { return Cursor::crosshair; }
    Cursor operator()(const DraggingGuide&) const { return Cursor::move; }
    Cursor operator()(const DraggingHandlebar&) const { return Cursor::move; }
    Cursor operator()(const Brushing&) const { return Cursor::crosshair; }
    Cursor operator()(const DraggingTransform& mode) const { return grip_cursor(mode.grip); }
    Cursor operator()(const PullingGuide& mode) const {
        return mode.angle == 0.0 ? Cursor::vertical : Cursor::horizontal;
    }
    Cursor operator()(const DraggingPicture&) const { return Cursor::move; }
    Cursor operator()(const DraggingSelection&) const { return Cursor::move; }
};

}  // namespace

Cursor canvas_cursor(const CanvasMode& mode, const EditorState& state, bool space_is_held) {
    if (space_is_held && std::holds_alternative<CanvasIdle>(mode)) return Cursor::move;
    return std::visit(CanvasCursor{state}, mode);
}

Cursor plot_cursor(const PlotMode& mode, const EditorState& state, bool space_is_held) {
    const bool is_idle = std::holds_alternative<PlotIdle>(mode) || std::holds_alternative<DoubleClickingPlot>(mode);
    if (std::holds_alternative<PanningPlot>(mode) || (is_idle && space_is_held)) return Cursor::move;
    if (!is_idle || is_one_of<HoveredKnot, HoveredParameter>(state.hover)) return Cursor::horizontal;
    return Cursor::arrow;
}

}  // namespace batten::editor
