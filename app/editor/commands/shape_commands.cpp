#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"
#include "core/edit/fair.h"
#include "core/edit/offset.h"
#include "core/edit/shape_edit.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;

core::Vector pair_at(const Arguments& arguments, std::size_t i) {
    return {arguments.number(i), arguments.number(i + 1)};
}

Outcome<Edit> move_curve_point(const EditorState& state, const Arguments& arguments) {
    const core::Curve& curve = active_curve(state);
    return edit_active(state, core::move_curve_point(curve, arguments.number(0), pair_at(arguments, 1)));
}

Outcome<Edit> set_tangent(const EditorState& state, const Arguments& arguments) {
    const core::Curve& curve = active_curve(state);
    const double u = arguments.number(0);
    return edit_active(state,
                       core::move_curve_point_and_tangent(curve, u, core::point_at(curve, u), pair_at(arguments, 1)));
}

Outcome<Edit> move_point_and_tangent(const EditorState& state, const Arguments& arguments) {
    return edit_active(state, core::move_curve_point_and_tangent(active_curve(state), arguments.number(0),
                                                                 pair_at(arguments, 1), pair_at(arguments, 3)));
}

Outcome<Edit> fair(const EditorState& state, const Arguments& arguments) {
    return edit_active(state, core::fair(active_curve(state), arguments.number(0)).map([](core::Approximation faired) {
        return std::move(faired.curve);
    }));
}

Outcome<Edit> offset(const EditorState& state, const Arguments& arguments) {
    auto found = core::offset(active_curve(state), arguments.number(0), arguments.number(1));
    if (!found) return tl::unexpected(core::describe(found.error()));
    const std::string& name = state.history.present().active_curve()->name;
    Edit edit = with_curve(state, "offset of " + name, std::move(found->curve));
    edit.error = found->error;
    return edit;
}

template <int inverse_share>
std::optional<Argument> part_of_size(const EditorState& state) {
    return share_of_size(state, 1.0 / inverse_share);
}

void add_point_moves(std::vector<CommandSpec>& table) {
    const ParameterSpec u{"u", Kind::number, "which point, in the domain", current_parameter};
    const ParameterSpec x{"x", Kind::number, "its new x"};
    const ParameterSpec y{"y", Kind::number, "its new y"};
    const ParameterSpec dx{"dx", Kind::number, "x of the derivative there"};
    const ParameterSpec dy{"dy", Kind::number, "y of the derivative there"};
    table.push_back({.name = "move-curve-point",
                     .title = "Move curve point",
                     .explanation = "Moves the point C(u) of the curve, with the least change of the control points.",
                     .group = CommandGroup::curve,
                     .submenu = "Shape",
                     .effect = ShapeEffect::changes,
                     .parameters = {u, x, y},
                     .refusal = no_editable_curve,
                     .edit = move_curve_point});
    table.push_back(
        {.name = "set-tangent",
         .title = "Set tangent",
         .explanation = "Sets the derivative at u and keeps C(u), with the least change of the control points.",
         .group = CommandGroup::curve,
         .submenu = "Shape",
         .effect = ShapeEffect::changes,
         .parameters = {u, dx, dy},
         .refusal = no_editable_curve,
         .edit = set_tangent});
    table.push_back(
        {.name = "move-point-and-tangent",
         .title = "Move curve point and tangent",
         .explanation = "Sets the point and the derivative at u, with the least change of the control points.",
         .group = CommandGroup::curve,
         .submenu = "Shape",
         .effect = ShapeEffect::changes,
         .parameters = {u, x, y, dx, dy},
         .refusal = no_editable_curve,
         .edit = move_point_and_tangent});
}

}  // namespace

void add_shape_commands(std::vector<CommandSpec>& table) {
    add_point_moves(table);
    table.push_back(
        {.name = "fair",
         .title = "Fair curve",
         .explanation = "Lets the curvature vary less, no farther from the old curve than a distance; the "
                        "ends stay.",
         .group = CommandGroup::curve,
         .submenu = "Shape",
         .effect = ShapeEffect::changes,
         .parameters = {{"distance", Kind::number, "how far the curve may move, above 0", part_of_size<100>}},
         .refusal = no_editable_curve,
         .edit = fair});
    table.push_back({.name = "offset",
                     .title = "Offset curve",
                     .explanation = "Adds the curve at a constant distance beside the active one.",
                     .group = CommandGroup::make,
                     .parameters = {{"distance", Kind::number, "to the left, negative to the right", grid_step},
                                    {"tolerance", Kind::number, "the largest error, above 0", part_of_size<1000000>}},
                     .refusal = no_curve,
                     .edit = offset,
                     .label = [](const EditorState&, const Arguments& arguments) {
                         return "Add offset by " + number_text(arguments.number(0));
                     }});
}

}  // namespace batten::editor
