#include <algorithm>
#include <cmath>

#include "app/editor/derived/blend_lines.h"
#include "app/editor/derived/construction_cells.h"
#include "app/editor/pointer/brush.h"
#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/gesture.h"
#include "app/editor/pointer/handlebar.h"
#include "app/editor/pointer/hint_text.h"
#include "app/editor/pointer/joint_command.h"
#include "app/editor/pointer/shape_hint.h"
#include "app/editor/pointer/transform_box.h"
#include "app/editor/state/selected_parts.h"
#include "app/editor/upkeep.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/length.h"
#include "app/editor/words/number_column.h"
#include "app/editor/words/wording.h"
#include "core/base/sentence.h"
#include "core/evaluate/evaluate.h"
#include "core/make/fit_points.h"

namespace batten::editor {
namespace {

using core::sentence;

std::string grip_hint(TransformGrip grip) {
    switch (grip.kind) {
        case GripKind::scale:
            return "Drag to scale from the opposite side, or from the pivot that you chose · Shift keeps proportions";
        case GripKind::turn:
            return "Drag to turn about the pivot · Ctrl keeps to steps";
        case GripKind::shear:
            return "Drag along the side to shear · Ctrl keeps to steps";
        case GripKind::pivot:
            return "Drag the pivot to where nothing shall move · click to hold it, or to let it go";
        case GripKind::inside:
            break;
    }
    return "Drag to move · Shift keeps to an axis, Ctrl to the grid";
}

std::string transforming_hint(TransformGrip grip) {
    switch (grip.kind) {
        case GripKind::scale:
            return "Type a factor or percent · Shift keeps proportions, Ctrl to the grid · Escape restores";
        case GripKind::turn:
        case GripKind::shear:
            return "Type an angle · Ctrl keeps to steps · Escape restores";
        case GripKind::pivot:
            return "Release to put the pivot here · Escape restores";
        case GripKind::inside:
            break;
    }
    return "Type a way · Shift keeps to an axis, Ctrl to the grid · Escape restores";
}

std::string knot_value(const core::Curve& curve, std::size_t stored_index) {
    const auto stored = curve.knots().stored();
    return stored_index < stored.size() ? number_text(stored[stored_index], 6) : "";
}

std::string weight_in(const EditorState& state, const core::Curve& curve, std::size_t i) {
    return weight_text(curve.weights()[i], state.derived.weights_of(curve)->column);
}

std::string place_in(const EditorState& state, const core::Curve& curve, core::Point place) {
    return place_text(state.shown().units, state.derived.of(curve)->size, place);
}

bool has_point(const core::Curve& curve, std::size_t i) {
    return i < curve.control_points().size();
}

std::size_t next_point(const core::Curve& curve, std::size_t i) {
    return (i + 1) % curve.control_points().size();
}

std::string all_selected_hint() {
    return "Drag to move all that is selected · Shift-click takes this out · click to select it alone";
}

/// What the select tool does to the hovered thing; empty where it does nothing special.
struct SelectHint {
    const EditorState& state;
    const core::Curve& curve;

    std::string operator()(const HoveredPoint& h) const {
        if (state.selection.is_over_curves() && (state.selection.is_whole || state.selection.contains_point(h.index)))
            return all_selected_hint();
        const std::size_t selected = state.selection.points.size();
        if (selected > 1 && state.selection.contains_point(h.index))
            return sentence("Drag to move the {count} selected points · click to select {point} alone",
                            {{"count", selected}, {"point", point_text(h.index)}});
        if (parameter_at_point(curve, h.index))
            return sentence("Drag {point} to move it · hold Alt to change its weight · Ctrl-click for the tangent",
                            {{"point", point_text(h.index)}});
        return sentence("Drag {point} to move it · hold Alt to change its weight", {{"point", point_text(h.index)}});
    }
    std::string operator()(const HoveredWeightRing& h) const {
        if (!has_point(curve, h.index)) return {};
        return sentence("Drag up or right to raise the weight of {point}, now {weight}, down or left to lower it",
                        {{"point", point_text(h.index)}, {"weight", weight_in(state, curve, h.index)}});
    }
    std::string operator()(const HoveredKnot& h) const {
        return sentence(
            "Drag the knot {u} along the curve (changes the shape) · double-click to raise its multiplicity (keeps the "
            "shape)",
            {{"u", knot_value(curve, h.index)}});
    }
    std::string operator()(const HoveredCurve& h) const {
        if (state.selection.is_whole) return all_selected_hint();
        return sentence(
            "Drag the curve to move C({u}) (changes the shape) · click for its tangent · double-click to insert a knot "
            "there (keeps the shape)",
            {{"u", parameter_text(curve, h.u)}});
    }
    std::string operator()(const HoveredParameter&) const {
        return sentence("Drag C(u) along the curve · double-click to insert a knot at u = {u} (keeps the shape)",
                        {{"u", parameter_text(curve, state.parameter())}});
    }
    std::string operator()(const HoveredCell&) const {
        const core::DeBoorTriangle triangle = core::de_boor_triangle(curve, state.parameter());
        const auto place = hovered_cell(state, triangle);
        if (!place || place->level == 0) return {};
        return sentence("{line} · right-click for what can be done at u",
                        {{"line", plain_text(blend_line({{curve, triangle, state.view.notation}, *place}))}});
    }
    std::string operator()(const HoveredFarinPoint& h) const {
        return sentence("Drag the Farin point between {point} and {next} to change the ratio of their weights",
                        {{"point", point_text(h.leg)}, {"next", point_text(next_point(curve, h.leg))}});
    }
    std::string operator()(const HoveredLifted& h) const {
        if (!h.index) return "Drag to turn the view · the wheel enlarges it";
        return sentence("Drag the lifted {point} along its ray to change its weight",
                        {{"point", point_text(*h.index)}});
    }
    std::string operator()(const HoveredHodograph& h) const {
        return h.order == 1 ? "The derivative C′(u), as a curve" : "The second derivative C″(u), as a curve";
    }
    std::string operator()(const HoveredLeg& h) const {
        if (!has_point(curve, h.index)) return {};
        return sentence("Double-click to add a control point between {point} and {next} (changes the shape)",
                        {{"point", point_text(h.index)}, {"next", point_text(next_point(curve, h.index))}});
    }
    std::string operator()(const HoveredFitPoint&) const {
        return "Drag to move this point of the curve · double-click makes or smooths a corner · right-click for more";
    }
    std::string operator()(const HoveredFitHandle&) const {
        return "Drag to turn the tangent, or to make it stronger · Ctrl keeps to the grid, Shift to one axis";
    }
    std::string operator()(const HoveredHandle& h) const {
        if (h.handle == ViewHandle::comb) return "Drag to make the comb longer or shorter";
        if (h.handle == ViewHandle::line) return "Drag to move the line · Shift keeps to one axis";
        return "Drag to turn the line · Ctrl keeps to the grid, Shift to one axis";
    }
    std::string operator()(const HoveredHandlebar& h) const {
        return h.part == HandlebarPart::middle
                   ? "Drag to move the curve here, its tangent with it · double-click to insert a knot (keeps the "
                     "shape)"
                   : "Drag to turn the tangent, or to make it stronger · Ctrl keeps to the grid, Shift to one axis";
    }
    std::string operator()(const HoveredGuide&) const {
        return "Drag to move the guide · onto a ruler, or right-click, to remove it";
    }
    std::string operator()(const HoveredGrip& h) const { return grip_hint(h.grip); }
    std::string operator()(const HoveredRuler&) const { return "Drag a guide out of the ruler"; }
    template <class Other>
    std::string operator()(const Other&) const {
        return {};
    }
};

std::string other_point_hint(const EditorState& state, const HoveredOtherPoint& hovered) {
    const auto selected = selected_box(state);
    const SelectedPart* part = part_of(selected->parts, hovered.curve);
    const bool is_selected =
        part != nullptr && (part->is_whole() || std::ranges::binary_search(part->points, hovered.index));
    if (is_selected) return all_selected_hint();
    return sentence("Drag {point} of '{name}' to move it · Shift-click selects it, too",
                    {{"point", point_text(hovered.index)}, {"name", state.shown().curves[hovered.curve].name}});
}

std::string other_curve_hint(const EditorState& state, std::size_t index) {
    const core::Place name("name", state.shown().curves[index].name);
    const auto selected = selected_box(state);
    const SelectedPart* part = part_of(selected->parts, index);
    if (part != nullptr && part->is_whole())
        return sentence("Drag to move all that is selected · Shift-click takes '{name}' out", {name});
    return sentence("Click to make '{name}' the active curve · Shift-click selects it, too", {name});
}

std::string select_hint(const EditorState& state) {
    const core::DocumentCurve* active = state.shown().active_curve();
    if (const auto* other = std::get_if<HoveredOtherCurve>(&state.hover))
        if (other->index < state.shown().curves.size()) return other_curve_hint(state, other->index);
    if (const auto* point = std::get_if<HoveredOtherPoint>(&state.hover);
        point != nullptr && is_in(*point, state.shown()))
        return other_point_hint(state, *point);
    if (std::holds_alternative<HoveredRuler>(state.hover)) return "Drag a guide out of the ruler";
    if (std::holds_alternative<HoveredPicture>(state.hover))
        return "Drag the picture to move it · Shift-drag selects points in a box · the inspector scales, dims and "
               "locks it";
    if (active == nullptr) return "Draw a curve with the pen (N) or open a file (Ctrl+O)";
    if (active->locked) return locked_sentence(*active);
    const std::string hint = std::visit(SelectHint{state, *active->curve}, state.hover);
    return hint.empty() ? "Drag to select points in a box, with Ctrl of all curves · Space-drag pans · the wheel "
                          "zooms, with Shift "
                          "it pans"
                        : hint;
}

std::string pencil_hint(const EditorState& state) {
    if (std::holds_alternative<HoveredCurve>(state.hover) && can_edit_curve(state))
        return "Drag along and back onto the curve to draw this part of it anew (changes the shape) · Alt draws a new "
               "curve · Escape leaves the tool";
    return "Drag to draw a new curve · back to its beginning closes it · Escape leaves the tool";
}

std::string transform_hint(const EditorState& state) {
    if (std::holds_alternative<HoveredGrip>(state.hover) || std::holds_alternative<HoveredOtherCurve>(state.hover) ||
        std::holds_alternative<HoveredRuler>(state.hover))
        return select_hint(state);
    const std::optional<TransformBox> box = transform_box(state);
    if (box && box->box.lower == box->box.upper)
        return "Drag the point to move it · drag around several to scale and turn them · Escape leaves the tool";
    return "Drag the handles of the box, its sides or what is in it · drag around points to take them alone · Escape "
           "leaves the tool";
}

std::string axis_hint(const AxisPick& pick) {
    if (!needs_axis(pick.use)) return "Click the center · type its place · Escape gives up";
    return pick.first ? "Click the second point of the axis · Escape gives up"
                      : "Click the first point of the axis · Escape gives up";
}

std::string gauge_hint(const PictureGauge& gauge) {
    return gauge.points.empty() ? "Click the first point of the picture · Escape gives up"
                                : "Click the second point, whose distance from the first you know · Escape gives up";
}

std::string tool_hint(const EditorState& state) {
    if (state.axis_pick) return axis_hint(*state.axis_pick);
    if (is_gauging(state)) return gauge_hint(*state.gauge);
    if (state.tool == Tool::draw_curve)
        return sentence(
            "Click to set the first point of a new curve by {mode} · right-click for other pens · Escape leaves",
            {{"mode", core::title_of(state.view.pen_mode)}});
    if (state.tool == Tool::joint) return joint_hint(state, {});
    if (state.tool == Tool::brush) return brush_hint(state, {});
    if (state.tool == Tool::shape) return shape_hint(state.view.shape_kind, 0);
    if (state.tool == Tool::pencil) return pencil_hint(state);
    if (state.tool == Tool::transform && can_edit_curve(state)) return transform_hint(state);
    if (state.tool == Tool::select || !can_edit_curve(state)) return select_hint(state);
    const bool is_on_knot = std::holds_alternative<HoveredKnot>(state.hover);
    switch (state.tool) {
        case Tool::add_point:
            return "Click to add a control point to the nearest leg or end (changes the shape) · hold Ctrl to keep to "
                   "the grid · Escape leaves the tool";
        case Tool::insert_knot:
            return is_on_knot
                       ? "Click to raise the multiplicity of this knot (keeps the shape) · Escape leaves the tool"
                       : "Click on the curve to insert a knot there (keeps the shape) · Escape leaves the tool";
        case Tool::weight:
            return "Drag a control point up or right to raise its weight, down or left to lower it · Escape leaves the "
                   "tool";
        case Tool::parameter:
            return "Drag to set the parameter u on the curve · Escape leaves the tool";
        case Tool::select:
        case Tool::draw_curve:
        case Tool::shape:
        case Tool::pencil:
        case Tool::joint:
        case Tool::brush:
        case Tool::transform:
            break;
    }
    return {};
}

/// One case for each mode, telling where the drag has come to.
struct ModeHint {
    const EditorState& state;
    const core::Curve* curve = state.active_curve();

    std::string operator()(const CanvasIdle&) const { return tool_hint(state); }
    std::string operator()(const DoubleClicking&) const { return tool_hint(state); }
    std::string operator()(const PickingJoint& mode) const { return joint_hint(state, mode); }
    std::string operator()(const DraggingPoints& mode) const {
        if (mode.indices.size() > 1)
            return sentence("Moving {count} points · Ctrl snaps to the grid · Shift keeps to an axis · Escape restores",
                            {{"count", mode.indices.size()}});
        if (curve == nullptr || !has_point(*curve, mode.grabbed)) return {};
        return sentence("{point} at {place} · Ctrl snaps to the grid · Shift keeps to an axis · Escape restores",
                        {{"point", point_text(mode.grabbed)},
                         {"place", place_in(state, *curve, curve->control_points()[mode.grabbed])}});
    }
    std::string operator()(const DraggingWeight& mode) const {
        if (curve == nullptr || !has_point(*curve, mode.index)) return {};
        return sentence(
            "Weight of {point}: {weight} · up or right raises it, down or left lowers it · Ctrl keeps to two digits · "
            "Escape restores",
            {{"point", point_text(mode.index)}, {"weight", weight_in(state, *curve, mode.index)}});
    }
    std::string operator()(const DraggingFarinPoint& mode) const {
        if (curve == nullptr || !has_point(*curve, mode.leg)) return {};
        const std::size_t next = next_point(*curve, mode.leg);
        return sentence(
            "The weight of {next} is {ratio} times that of {point} · Ctrl keeps to twelfths · Escape restores",
            {{"next", point_text(next)},
             {"ratio", number_text(curve->weights()[next] / curve->weights()[mode.leg])},
             {"point", point_text(mode.leg)}});
    }
    std::string operator()(const DraggingLiftedWeight& mode) const {
        if (curve == nullptr || !has_point(*curve, mode.index)) return {};
        return sentence("Weight of {point}: {weight} · Escape restores",
                        {{"point", point_text(mode.index)}, {"weight", weight_in(state, *curve, mode.index)}});
    }
    std::string operator()(const TurningOrbit&) const { return "Turning the view"; }
    std::string operator()(const DraggingPicture&) const { return "Moving the picture · Shift keeps to an axis"; }
    std::string operator()(const BoxSelecting& mode) const {
        return mode.takes_all_curves ? "Release to select the points and curves in the box"
                                     : "Release to select the points in the box";
    }
    std::string operator()(const DraggingSelection&) const {
        return "Moving all that is selected · Ctrl snaps to the grid · Shift keeps to an axis · Escape restores";
    }
    std::string operator()(const Panning&) const { return "Panning"; }
    std::string operator()(const DraggingParameter&) const { return parameter_text(state); }
    std::string operator()(const DraggingCurveKnot& mode) const {
        if (curve == nullptr) return {};
        return sentence("Knot at {u} · Escape restores", {{"u", knot_value(*curve, moving_knot(state, mode.index))}});
    }
    std::string operator()(const DraggingCurvePoint& mode) const {
        return curve == nullptr ? std::string{} : curve_point_hint(mode.u);
    }
    std::string curve_point_hint(double u) const {
        return sentence(
            "C({u}) at {place} · Ctrl snaps to the grid · Shift keeps to an axis · Escape restores",
            {{"u", parameter_text(*curve, u)}, {"place", place_in(state, *curve, core::point_at(*curve, u))}});
    }
    std::string operator()(const DraggingHandle& mode) const {
        return mode.start.handle == ViewHandle::comb
                   ? "Drag away from the curve for a longer comb · Escape restores"
                   : "Ctrl snaps to the grid · Shift keeps to an axis · Escape restores";
    }
    std::string operator()(const DraggingFitPoint& mode) const {
        const core::DocumentCurve* active = state.shown().active_curve();
        if (active == nullptr || active->fit == nullptr || mode.index >= active->fit->points.size()) return {};
        return sentence(
            "Fit point {index} at {place} · Ctrl snaps to the grid · Shift keeps to an axis · Escape restores",
            {{"index", mode.index}, {"place", place_in(state, *active->curve, active->fit->points[mode.index].place)}});
    }
    std::string operator()(const PencilStroke& mode) const {
        return mode.redraws ? "Release on the curve to replace the part between, elsewhere for a new curve · Escape "
                              "gives up"
                            : "Release to end the curve · Escape gives up";
    }
    std::string operator()(const DraggingFitHandle&) const {
        return "Ctrl snaps to the grid · Shift keeps to an axis · Escape restores";
    }
    std::string operator()(const DraggingHandlebar& mode) const {
        if (curve == nullptr || !state.selection.handlebar || mode.part != HandlebarPart::middle)
            return "Ctrl snaps to the grid · Shift keeps to an axis · Escape restores";
        return curve_point_hint(*state.selection.handlebar);
    }
    std::string operator()(const Brushing& mode) const { return brush_hint(state, mode); }
    std::string operator()(const DrawingCurve& mode) const {
        if (mode.pulled_px) return "Drag to draw out the handle of a smooth point; a click makes a corner";
        if (mode.closes) return "Click to close the curve";
        if (mode.points.size() < 2) return "Click to set the next point · Backspace takes it back · Escape gives up";
        return "Click to set the next point, or the first one to close · Enter or right-click ends · Backspace takes "
               "back";
    }
    std::string operator()(const DrawingShape& mode) const { return shape_hint(mode.kind, mode.points.size()); }
    std::string operator()(const DraggingTransform& mode) const { return transforming_hint(mode.grip); }
    std::string operator()(const DraggingGuide&) const {
        return "Release to put the guide here, or over a ruler to remove it · Escape restores";
    }
    std::string operator()(const PullingGuide&) const {
        return "Release to put the guide here · over a ruler, or by Escape, it is given up";
    }
};

}  // namespace

std::string canvas_hint(const CanvasMode& mode, const EditorState& state) {
    std::string hint = std::visit(ModeHint{state}, mode);
    const auto& place = state.placing.place;
    if (!state.placing.typed.is_empty())
        hint = "Enter takes what is typed · Tab goes to the other number · Escape drops it";
    else if (place && place->snap)
        hint = sentence("{snap} · Alt lets go · {hint}", {{"snap", place->snap->sentence}, {"hint", hint}});
    return notated(hint, state.view.notation);
}

}  // namespace batten::editor
