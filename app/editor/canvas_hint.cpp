#include <cmath>

#include "app/editor/canvas_mode.h"
#include "app/editor/formula.h"
#include "app/editor/gesture.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {
namespace {

std::string point_name(std::size_t i) {
    return plain_text("P_{" + std::to_string(i) + "}");
}

std::string position_text(core::Point point) {
    return "(" + number_text(point.x) + ", " + number_text(point.y) + ")";
}

std::string knot_value(const core::Curve& curve, std::size_t stored_index) {
    const auto stored = curve.knots().stored();
    return stored_index < stored.size() ? number_text(stored[stored_index]) : "";
}

bool has_point(const core::Curve& curve, std::size_t i) {
    return i < curve.control_points().size();
}

/// What the select tool does to the hovered thing; empty where it does nothing special.
struct SelectHint {
    const EditorState& state;
    const core::Curve& curve;

    std::string operator()(const HoveredPoint& h) const {
        const std::size_t selected = state.selection.points.size();
        if (selected > 1 && state.selection.contains_point(h.index))
            return "Drag to move the " + std::to_string(selected) + " selected points · click to select " +
                   point_name(h.index) + " alone";
        return "Drag " + point_name(h.index) + " to move it · hold Alt to change its weight";
    }
    std::string operator()(const HoveredWeightRing& h) const {
        if (!has_point(curve, h.index)) return {};
        return "Drag up or right to raise the weight of " + point_name(h.index) + ", now " +
               number_text(curve.weights()[h.index]) + ", down or left to lower it";
    }
    std::string operator()(const HoveredKnot& h) const {
        return "Drag the knot " + knot_value(curve, h.index) +
               " along the curve (changes the shape) · double-click to raise its multiplicity (keeps the shape)";
    }
    std::string operator()(const HoveredCurve& h) const {
        return "Drag the curve to move C(" + number_text(h.u) +
               ") (changes the shape) · double-click to insert a knot there (keeps the shape)";
    }
    std::string operator()(const HoveredParameter&) const {
        return "Drag C(u) along the curve · double-click to insert a knot at u = " + number_text(state.parameter()) +
               " (keeps the shape)";
    }
    std::string operator()(const HoveredLeg& h) const {
        if (!has_point(curve, h.index)) return {};
        return "Double-click to add a control point between " + point_name(h.index) + " and " +
               point_name((h.index + 1) % curve.control_points().size()) + " (changes the shape)";
    }
    template <class Other>
    std::string operator()(const Other&) const {
        return {};
    }
};

std::string select_hint(const EditorState& state) {
    const core::DocumentCurve* active = state.shown().active_curve();
    if (const auto* other = std::get_if<HoveredOtherCurve>(&state.hover))
        if (other->index < state.shown().curves.size())
            return "Click to make '" + state.shown().curves[other->index].name + "' the active curve";
    if (active == nullptr) return "Draw a curve with the pen (N) or open a file (Ctrl+O)";
    if (active->locked) return "'" + active->name + "' is locked; unlock it in the inspector to edit it";
    const std::string hint = std::visit(SelectHint{state, *active->curve}, state.hover);
    return hint.empty() ? "Drag to select points in a box · middle-drag or Space-drag pans · the wheel zooms" : hint;
}

std::string tool_hint(const EditorState& state) {
    if (state.tool == Tool::draw_curve)
        return "Click to set the first point of a new curve · hold Ctrl to keep to the grid";
    if (state.tool == Tool::select || !can_edit_curve(state)) return select_hint(state);
    const bool is_on_knot = std::holds_alternative<HoveredKnot>(state.hover);
    switch (state.tool) {
        case Tool::add_point:
            return "Click to add a control point to the nearest leg or end (changes the shape) · hold Ctrl to keep to "
                   "the grid";
        case Tool::insert_knot:
            return is_on_knot ? "Click to raise the multiplicity of this knot (keeps the shape)"
                              : "Click on the curve to insert a knot there (keeps the shape)";
        case Tool::weight:
            return "Drag a control point up or right to raise its weight, down or left to lower it";
        case Tool::parameter:
            return "Drag to set the parameter u on the curve";
        case Tool::select:
        case Tool::draw_curve:
            break;
    }
    return {};
}

/// One case for each mode, telling where the drag has come to.
struct ModeHint {
    const EditorState& state;
    const core::Curve* curve = state.active_curve();

    std::string operator()(const CanvasIdle&) const { return tool_hint(state); }
    std::string operator()(const DraggingPoints& mode) const {
        const std::string keys = " · Ctrl snaps to the grid · Shift keeps to an axis · Escape restores";
        if (mode.indices.size() > 1) return "Moving " + std::to_string(mode.indices.size()) + " points" + keys;
        if (curve == nullptr || !has_point(*curve, mode.grabbed)) return {};
        return point_name(mode.grabbed) + " at " + position_text(curve->control_points()[mode.grabbed]) + keys;
    }
    std::string operator()(const DraggingWeight& mode) const {
        if (curve == nullptr || !has_point(*curve, mode.index)) return {};
        return "Weight of " + point_name(mode.index) + ": " + number_text(curve->weights()[mode.index]) +
               " · up or right raises it, down or left lowers it · Escape restores";
    }
    std::string operator()(const BoxSelecting&) const { return "Release to select the points in the box"; }
    std::string operator()(const Panning&) const { return "Panning"; }
    std::string operator()(const DraggingParameter&) const { return "u = " + number_text(state.parameter()); }
    std::string operator()(const DraggingCurveKnot& mode) const {
        if (curve == nullptr) return {};
        return "Knot at " + knot_value(*curve, moving_knot(state, mode.index)) + " · Escape restores";
    }
    std::string operator()(const DraggingCurvePoint& mode) const {
        if (curve == nullptr) return {};
        return "C(" + number_text(mode.u) + ") at " + position_text(core::point_at(*curve, mode.u)) +
               " · Ctrl snaps to the grid · Shift keeps to an axis · Escape restores";
    }
    std::string operator()(const DrawingCurve& mode) const {
        if (mode.points.size() < 2) return "Click to set the next point · Escape gives up";
        return "Click to set the next point · double-click or Enter ends the curve · Escape gives up";
    }
};

}  // namespace

std::string canvas_hint(const CanvasMode& mode, const EditorState& state) {
    return std::visit(ModeHint{state}, mode);
}

}  // namespace batten::editor
