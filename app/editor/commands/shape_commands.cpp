#include "app/editor/commands/shape_commands.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/refusal.h"
#include "core/base/sentence.h"
#include "core/edit/fair.h"
#include "core/edit/offset.h"
#include "core/edit/shape_edit.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

Outcome<Edit> move_curve_point(const EditorState& state, const MoveCurvePoint& command) {
    return edit_active(state,
                       core::move_curve_point(active_curve(state), command.u, command.position, pinned_points(state)));
}

Outcome<Edit> set_tangent(const EditorState& state, const SetTangent& command) {
    const core::Curve& curve = active_curve(state);
    return edit_active(
        state, core::move_curve_point_and_tangent(curve, command.u, core::point_at(curve, command.u, command.side),
                                                  command.derivative, command.side, pinned_points(state)));
}

Outcome<Edit> move_point_and_tangent(const EditorState& state, const MovePointAndTangent& command) {
    return edit_active(
        state, core::move_curve_point_and_tangent(active_curve(state), command.u, command.position, command.derivative,
                                                  core::Side::right, pinned_points(state)));
}

Outcome<Edit> fair(const EditorState& state, const Fair& command) {
    return edit_active(state, core::fair(active_curve(state), command.distance, state.progress,
                                         held_points(*state.history.present().active_curve())));
}

core::Result<core::OffsetCurves> offset_curves(const EditorState& state, const Offset& command) {
    const core::Curve& curve = active_curve(state);
    if (command.side)
        return core::offset_shape(
            curve, {command.distance, command.tolerance, *command.side, command.corners, command.caps}, state.progress);
    return core::offset(curve, command.distance, command.tolerance, state.progress).map([](core::Approximation found) {
        return core::OffsetCurves{{std::move(found.curve)}, found.error};
    });
}

Outcome<Edit> offset(const EditorState& state, const Offset& command) {
    auto found = offset_curves(state, command);
    if (!found) return refused(state, found.error());
    const std::string& name = state.history.present().active_curve()->name;
    const std::size_t count = found->curves.size();
    Edit edit = with_curves(state, core::sentence("offset of {name}", {{"name", name}}), std::move(found->curves));
    // Lines, arcs and polygons are exact.
    if (found->error > 0.0) edit.error = found->error;
    if (count > 1)
        edit.remark = core::sentence({.one = "it is one curve", .many = "it consists of {count} curves"}, count);
    return edit;
}

core::OffsetSide left_side(const EditorState&) {
    return core::OffsetSide::left;
}

std::optional<core::Point> point_at_parameter(const EditorState& state) {
    if (no_curve(state)) return std::nullopt;
    return core::point_at(active_curve(state), state.parameter());
}

std::optional<core::Vector> derivative_at_parameter(const EditorState& state) {
    if (no_curve(state)) return std::nullopt;
    return core::derivatives_at(active_curve(state), state.parameter(), 1)[1];
}

template <class Command>
Field parameter_field() {
    return field::parameter<&Command::u>("u", "which point, in the domain")
        .template suggesting<suggest::current_parameter>();
}

template <class Command>
Field position_field() {
    return field::position<&Command::position>({"x", "its new x"}, {"y", "its new y"})
        .template beginning_with<point_at_parameter>();
}

template <class Command>
Field derivative_field() {
    return field::vector<&Command::derivative>({"dx", "x of the derivative there"}, {"dy", "y of the derivative there"})
        .template beginning_with<derivative_at_parameter>();
}

}  // namespace

const CommandSpec& MoveCurvePoint::spec() {
    static const CommandSpec spec{
        .name = "move-curve-point",
        .title = "Move curve point",
        .explanation = "Moves the point C(u) of the curve, with the least change of the control points.",
        .synonyms = "drag",
        .group = CommandGroup::curve,
        .submenu = "Shape",
        .effect = ShapeEffect::changes,
        .fields = {parameter_field<MoveCurvePoint>(), position_field<MoveCurvePoint>()},
        .refusal = no_editable_curve,
        .run = body_of<move_curve_point>,
        .done = "Moved C({u}) to ({x}, {y})",
        .tells_smoothness = true};
    return spec;
}

const CommandSpec& SetTangent::spec() {
    static const CommandSpec spec{
        .name = "set-tangent",
        .title = "Set tangent",
        .explanation = "Sets the derivative at u and keeps C(u), with the least change of the control points.",
        .synonyms = "direction slope",
        .group = CommandGroup::curve,
        .submenu = "Shape",
        .effect = ShapeEffect::changes,
        .fields = {parameter_field<SetTangent>(), derivative_field<SetTangent>(),
                   field::choice<&SetTangent::side>("side", "of a knot at which the curve may turn")
                       .usually(core::Side::right)},
        .refusal = no_editable_curve,
        .run = body_of<set_tangent>,
        .done = "Set tangent at u = {u} to ({dx}, {dy})",
        .tells_smoothness = true};
    return spec;
}

const CommandSpec& MovePointAndTangent::spec() {
    static const CommandSpec spec{
        .name = "move-point-and-tangent",
        .title = "Move curve point and tangent",
        .explanation = "Sets the point and the derivative at u, with the least change of the control points.",
        .synonyms = "drag direction",
        .group = CommandGroup::curve,
        .submenu = "Shape",
        .effect = ShapeEffect::changes,
        .fields = {parameter_field<MovePointAndTangent>(), position_field<MovePointAndTangent>(),
                   derivative_field<MovePointAndTangent>()},
        .refusal = no_editable_curve,
        .run = body_of<move_point_and_tangent>,
        .done = "Moved C({u}) to ({x}, {y}), its tangent to ({dx}, {dy})",
        .tells_smoothness = true};
    return spec;
}

const CommandSpec& Fair::spec() {
    static const CommandSpec spec{
        .name = "fair",
        .title = "Fair curve",
        .explanation =
            "Makes the curvature vary less, within a distance of the old curve; the ends and given tangents stay.",
        .synonyms = "smooth",
        .group = CommandGroup::curve,
        .submenu = "Shape",
        .effect = ShapeEffect::changes,
        .fields = {field::length<&Fair::distance>("distance", "how far the curve may move, above 0")
                       .suggesting<suggest::hundredth_of_size>()},
        .refusal = no_editable_curve,
        .run = body_of<fair>,
        .at_work = "Fairing the curve",
        .done = "Faired curve",
        .tells_smoothness = true};
    return spec;
}

const CommandSpec& Offset::spec() {
    static const CommandSpec spec{
        .name = "offset",
        .title = "Offset curve",
        .explanation =
            "Adds the curves at a constant distance from the active one, without the loops where it comes too near.",
        .synonyms = "parallel outline inset stroke",
        .group = CommandGroup::make,
        .fields =
            {field::length<&Offset::distance>("distance", "to the left, negative to the right")
                 .suggesting<suggest::grid_step>(),
             field::length<&Offset::tolerance>("tolerance", "the largest error, above 0")
                 .suggesting<suggest::tolerance_of_offset>(),
             field::choice<&Offset::side>("side",
                                          "on which side, cut where it comes too near; without it nothing is cut")
                 .beginning_with<left_side>(),
             field::choice<&Offset::corners>("corners", "what goes around corners").usually(core::OffsetCorners::mitre),
             field::choice<&Offset::caps>("caps", "how both sides of an open curve are joined at its ends")
                 .usually(core::OffsetCaps::none)},
        .refusal = no_curve,
        .run = body_of<offset>,
        .at_work = "Offsetting the curve",
        .step = "Add offset by {distance}",
        .done = "Added offset by {distance}"};
    return spec;
}

void add_shape_commands(CommandTable& table) {
    add_all<MoveCurvePoint, SetTangent, MovePointAndTangent, Fair, Offset>(table);
}

}  // namespace batten::editor
