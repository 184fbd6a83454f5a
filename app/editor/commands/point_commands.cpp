#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"
#include "core/edit/point_edit.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;

constexpr const char* which_point = "the number of a control point, counted from 0";

Outcome<Edit> move_by(const EditorState& state, const std::vector<double>& points, core::Vector offset) {
    const Outcome<std::vector<std::size_t>> indices = indices_of(points, "a control point");
    if (!indices) return tl::unexpected(indices.error());
    return edit_active(state, core::move_control_points(active_curve(state), *indices, offset));
}

Outcome<Edit> move_points(const EditorState& state, const Arguments& arguments) {
    return move_by(state, arguments.numbers(0), {arguments.number(1), arguments.number(2)});
}

Outcome<Edit> set_point(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> index = index_of(arguments.number(0), "index");
    if (!index) return tl::unexpected(index.error());
    return edit_active(
        state, core::set_control_point(active_curve(state), *index, {arguments.number(1), arguments.number(2)}));
}

Outcome<Edit> set_weight(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> index = index_of(arguments.number(0), "index");
    if (!index) return tl::unexpected(index.error());
    return edit_active(state, core::set_weight(active_curve(state), *index, arguments.number(1)));
}

Outcome<Edit> add_point(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> index = index_of(arguments.number(0), "index");
    if (!index) return tl::unexpected(index.error());
    return edit_active(state,
                       core::add_control_point(active_curve(state), *index, {arguments.number(1), arguments.number(2)}),
                       Selection{{*index}, {}});
}

Outcome<Edit> delete_points(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::vector<std::size_t>> indices = indices_of(arguments.numbers(0), "a control point");
    if (!indices) return tl::unexpected(indices.error());
    return edit_active(state, core::delete_control_points(active_curve(state), *indices), Selection{});
}

Outcome<Edit> nudge(const EditorState& state, const Arguments& arguments) {
    const std::vector<std::size_t>& points = state.selection.points;
    return edit_active(
        state, core::move_control_points(active_curve(state), points, {arguments.number(0), arguments.number(1)}));
}

std::string label_of_nudge(const EditorState& state, const Arguments&) {
    const std::vector<std::size_t>& points = state.selection.points;
    return "Nudge " + points_text(points);
}

void add_moves(std::vector<CommandSpec>& table) {
    table.push_back({.name = "move-points",
                     .title = "Move points",
                     .explanation = "Moves control points by an offset.",
                     .group = CommandGroup::edit,
                     .effect = ShapeEffect::changes,
                     .parameters = {{"indices", Kind::numbers, "which control points, counted from 0"},
                                    {"dx", Kind::number, "to the right"},
                                    {"dy", Kind::number, "upwards"}},
                     .refusal = no_editable_curve,
                     .edit = move_points,
                     .label = [](const EditorState&, const Arguments& arguments) {
                         return "Move " + points_text(arguments.numbers(0));
                     }});
    table.push_back({.name = "set-point",
                     .title = "Set point",
                     .explanation = "Puts a control point where its coordinates say.",
                     .group = CommandGroup::edit,
                     .effect = ShapeEffect::changes,
                     .parameters = {{"index", Kind::number, which_point},
                                    {"x", Kind::number, "its new x"},
                                    {"y", Kind::number, "its new y"}},
                     .refusal = no_editable_curve,
                     .edit = set_point,
                     .label = [](const EditorState&, const Arguments& arguments) {
                         return "Move " + point_text(arguments.number(0));
                     }});
    table.push_back(
        {.name = "set-weight",
         .title = "Set weight",
         .explanation = "Sets the weight of a control point; a larger one pulls the curve towards the point.",
         .group = CommandGroup::edit,
         .effect = ShapeEffect::changes,
         .parameters = {{"index", Kind::number, which_point}, {"w", Kind::number, "its new weight, above 0"}},
         .refusal = no_editable_curve,
         .edit = set_weight,
         .label = [](const EditorState&, const Arguments& arguments) {
             return "Set weight of " + point_text(arguments.number(0));
         }});
}

void add_additions(std::vector<CommandSpec>& table) {
    table.push_back({.name = "add-point",
                     .title = "Add point",
                     .explanation = "Adds a control point, and with it a knot, before another one or at the end.",
                     .group = CommandGroup::edit,
                     .effect = ShapeEffect::changes,
                     .parameters = {{"index", Kind::number, "the number that the new control point will have"},
                                    {"x", Kind::number, "its x"},
                                    {"y", Kind::number, "its y"}},
                     .refusal = no_editable_curve,
                     .edit = add_point,
                     .label = [](const EditorState&, const Arguments& arguments) {
                         return "Add " + point_text(arguments.number(0));
                     }});
    table.push_back(
        {.name = "delete-points",
         .title = "Delete points",
         .explanation = "Deletes control points, and with each of them a knot.",
         .group = CommandGroup::edit,
         .effect = ShapeEffect::changes,
         .parameters = {{"indices", Kind::numbers, "which control points, counted from 0", selected_points}},
         .refusal = no_editable_curve,
         .edit = delete_points,
         .label = [](const EditorState&, const Arguments& arguments) {
             return "Delete " + points_text(arguments.numbers(0));
         }});
    table.push_back({.name = "nudge",
                     .title = "Nudge",
                     .explanation = "Moves the selected control points by an offset.",
                     .group = CommandGroup::edit,
                     .effect = ShapeEffect::changes,
                     .parameters = {{"dx", Kind::number, "to the right"}, {"dy", Kind::number, "upwards"}},
                     .refusal = no_editable_points,
                     .edit = nudge,
                     .label = label_of_nudge});
}

// The distance is an argument, so that a replay does not depend on the camera.
std::optional<Argument> tenth_of_grid_step(const EditorState& state) {
    return std::get<double>(*grid_step(state)) / 10.0;
}

template <int x, int y>
Outcome<Edit> nudge_towards(const EditorState& state, const Arguments& arguments) {
    const double distance = arguments.number(0);
    return nudge(state, Arguments({x * distance, y * distance}));
}

template <int x, int y>
void add_nudge(std::vector<CommandSpec>& table, const char* name, const char* title, Shortcut shortcut) {
    const bool is_far = shortcut.modifiers.shift;
    table.push_back({.name = name,
                     .title = title,
                     .explanation = is_far ? "Moves the selected control points by a step of the grid."
                                           : "Moves the selected control points by a tenth of a step of the grid.",
                     .group = CommandGroup::edit,
                     .effect = ShapeEffect::changes,
                     .shortcut = shortcut,
                     .parameters = {{"distance", Kind::number, "how far", is_far ? grid_step : tenth_of_grid_step}},
                     .refusal = no_editable_points,
                     .edit = nudge_towards<x, y>,
                     .label = label_of_nudge});
}

void add_nudges(std::vector<CommandSpec>& table) {
    constexpr Modifiers shift{false, true, false};
    add_nudge<-1, 0>(table, "nudge-left", "Nudge left", {Key::left, {}});
    add_nudge<1, 0>(table, "nudge-right", "Nudge right", {Key::right, {}});
    add_nudge<0, 1>(table, "nudge-up", "Nudge up", {Key::up, {}});
    add_nudge<0, -1>(table, "nudge-down", "Nudge down", {Key::down, {}});
    add_nudge<-1, 0>(table, "nudge-left-far", "Nudge left by a grid step", {Key::left, shift});
    add_nudge<1, 0>(table, "nudge-right-far", "Nudge right by a grid step", {Key::right, shift});
    add_nudge<0, 1>(table, "nudge-up-far", "Nudge up by a grid step", {Key::up, shift});
    add_nudge<0, -1>(table, "nudge-down-far", "Nudge down by a grid step", {Key::down, shift});
}

}  // namespace

void add_point_commands(std::vector<CommandSpec>& table) {
    add_moves(table);
    add_additions(table);
    add_nudges(table);
}

}  // namespace batten::editor
