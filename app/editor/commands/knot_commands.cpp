#include <array>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"
#include "core/edit/knot_edit.h"
#include "core/refine/knot_insertion.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;

constexpr const char* which_knot = "the number of a knot, counted from 0";

// The knot of the committed active curve that an argument names.
Outcome<std::size_t> knot_index(const EditorState& state, double value) {
    const Outcome<std::size_t> index = index_of(value, "index");
    const std::size_t count = active_curve(state).knots().stored().size();
    if (index && *index >= count)
        return tl::unexpected(core::describe(
            {core::CurveErrorCode::knot_index_out_of_range, *index, 0.0, 0.0, static_cast<double>(count - 1)}));
    return index;
}

std::string knot_text(const EditorState& state, double index) {
    return number_text(active_curve(state).knots().stored()[static_cast<std::size_t>(index)]);
}

// Selects the last of the knots that equal `u`.
Selection selection_of_value(const core::Curve& curve, double u) {
    const std::span<const double> knots = curve.knots().stored();
    for (std::size_t i = knots.size(); i-- > 0;)
        if (knots[i] == u) return {{}, i};
    return {};
}

Outcome<Edit> insert_at(const EditorState& state, double u) {
    core::Result<core::Curve> curve = core::insert_knot(active_curve(state), u);
    if (!curve) return tl::unexpected(core::describe(curve.error()));
    const Selection selection = selection_of_value(*curve, u);
    return edit_active(state, std::move(curve), selection);
}

Outcome<Edit> insert_knot(const EditorState& state, const Arguments& arguments) {
    return insert_at(state, arguments.number(0));
}

Outcome<Edit> insert_midpoints(const EditorState& state, const Arguments&) {
    return edit_active(state, core::insert_midpoint_knots(active_curve(state)));
}

Outcome<Edit> raise_knot(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> index = knot_index(state, arguments.number(0));
    if (!index) return tl::unexpected(index.error());
    return insert_at(state, active_curve(state).knots().stored()[*index]);
}

// Of a stack the knot at the side to which it is moved is taken; knots keep their order.
Selection selection_after_move(const EditorState& state, std::size_t index, double u) {
    const std::span<const double> knots = active_curve(state).knots().stored();
    const double old = knots[index];
    while (u > old && index + 1 < knots.size() && knots[index + 1] == old) ++index;
    while (u < old && index > 0 && knots[index - 1] == old) --index;
    return {state.selection.points, index};
}

Outcome<Edit> move_knot(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> index = knot_index(state, arguments.number(0));
    if (!index) return tl::unexpected(index.error());
    const std::optional<core::KnotMove> mode = core::value_named<core::KnotMove>(arguments.text(2));
    if (!mode) return tl::unexpected("mode is '" + arguments.text(2) + "'; it must be stop, push or snap");
    if (arguments.number(3) < 0.0) return tl::unexpected(Refusal("the snap distance must not be negative"));
    const core::Curve& curve = active_curve(state);
    const double u = arguments.number(1);
    return edit_active(state, core::move_knot(curve, *index, u, *mode, arguments.number(3)),
                       selection_after_move(state, *index, u));
}

Outcome<Edit> set_knot(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> index = knot_index(state, arguments.number(0));
    if (!index) return tl::unexpected(index.error());
    const core::Curve& curve = active_curve(state);
    const double u = arguments.number(1);
    return edit_active(state, core::set_knot(curve, *index, u), selection_after_move(state, *index, u));
}

Outcome<Edit> delete_knot(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> index = index_of(arguments.number(0), "index");
    if (!index) return tl::unexpected(index.error());
    return edit_active(state, core::delete_knot(active_curve(state), *index));
}

Outcome<Edit> set_knots(const EditorState& state, const Arguments& arguments) {
    return edit_active(state, core::set_knots(active_curve(state), arguments.numbers(0)));
}

struct NamedKind {
    const char* name;
    core::KnotKind kind;
    const char* label;
};

constexpr std::array named_kinds{
    NamedKind{"uniform", core::KnotKind::uniform, "Make knots uniform"},
    NamedKind{"clamped-uniform", core::KnotKind::clamped_uniform, "Make knots clamped uniform"},
    NamedKind{"bezier", core::KnotKind::bezier, "Make curve Bézier"},
    NamedKind{"piecewise-bezier", core::KnotKind::piecewise_bezier, "Make curve piecewise Bézier"},
    NamedKind{"periodic", core::KnotKind::periodic, "Make knots periodic"},
    NamedKind{"custom", core::KnotKind::custom, "Make knots custom"},
};

const NamedKind* kind_named(const std::string& name) {
    for (const NamedKind& named : named_kinds)
        if (name == named.name) return &named;
    return nullptr;
}

Outcome<Edit> set_kind(const EditorState& state, const Arguments& arguments) {
    const NamedKind* named = kind_named(arguments.text(0));
    if (named == nullptr)
        return tl::unexpected("kind is '" + arguments.text(0) +
                              "'; it must be uniform, clamped-uniform, bezier, piecewise-bezier, periodic or custom");
    return edit_active(state, core::set_knot_kind(active_curve(state), named->kind));
}

Outcome<Edit> toggle_closed(const EditorState& state, const Arguments&) {
    const core::Curve& curve = active_curve(state);
    return edit_active(state, core::set_periodic(curve, !curve.is_periodic()));
}

bool is_closed(const EditorState& state) {
    const core::Curve* curve = state.active_curve();
    return curve != nullptr && curve->is_periodic();
}

void add_insertions(std::vector<CommandSpec>& table) {
    table.push_back({.name = "insert-knot",
                     .title = "Insert knot",
                     .explanation = "Inserts a knot at u; the curve stays as it is and gains a control point.",
                     .group = CommandGroup::curve,
                     .submenu = "Knots",
                     .effect = ShapeEffect::keeps,
                     .shortcut = {Key::i, {}},
                     .parameters = {{"u", Kind::number, "where in the domain", current_parameter}},
                     .refusal = no_editable_curve,
                     .edit = insert_knot,
                     .label = [](const EditorState&, const Arguments& arguments) {
                         return "Insert knot " + number_text(arguments.number(0));
                     }});
    table.push_back({.name = "insert-midpoints",
                     .title = "Insert knots at all midpoints",
                     .explanation = "Inserts a knot in the middle of every span; the curve stays as it is.",
                     .group = CommandGroup::curve,
                     .submenu = "Knots",
                     .effect = ShapeEffect::keeps,
                     .refusal = no_editable_curve,
                     .edit = insert_midpoints});
    table.push_back({.name = "raise-knot",
                     .title = "Raise multiplicity of knot",
                     .explanation = "Inserts a knot once more where it is; the curve stays as it is.",
                     .group = CommandGroup::curve,
                     .submenu = "Knots",
                     .effect = ShapeEffect::keeps,
                     .parameters = {{"index", Kind::number, which_knot, selected_knot}},
                     .refusal = no_editable_curve,
                     .edit = raise_knot,
                     .label = [](const EditorState& state, const Arguments& arguments) {
                         return "Raise multiplicity of knot " + knot_text(state, arguments.number(0));
                     }});
}

std::optional<Argument> current_knot_move(const EditorState& state) {
    return core::name_of(state.view.knot_move);
}

std::optional<Argument> no_distance(const EditorState&) {
    return 0.0;
}

void add_moves(std::vector<CommandSpec>& table) {
    table.push_back(
        {.name = "move-knot",
         .title = "Move knot",
         .explanation = "Moves a knot towards u; at its neighbours it stops, pushes them along, or snaps onto them.",
         .group = CommandGroup::curve,
         .submenu = "Knots",
         .effect = ShapeEffect::changes,
         .parameters = {{"index", Kind::number, which_knot},
                        {"u", Kind::number, "where to"},
                        {"mode", Kind::text, "stop, push or snap", current_knot_move},
                        {"snap distance", Kind::number, "how near it jumps onto another knot", no_distance}},
         .refusal = no_editable_curve,
         .edit = move_knot,
         .label = [](const EditorState& state, const Arguments& arguments) {
             return "Move knot " + knot_text(state, arguments.number(0));
         }});
    table.push_back(
        {.name = "set-knot",
         .title = "Set knot",
         .explanation = "Sets a knot to a value between its neighbours.",
         .group = CommandGroup::curve,
         .submenu = "Knots",
         .effect = ShapeEffect::changes,
         .parameters = {{"index", Kind::number, which_knot, selected_knot}, {"u", Kind::number, "its new value"}},
         .refusal = no_editable_curve,
         .edit = set_knot,
         .label = [](const EditorState& state, const Arguments& arguments) {
             return "Set knot " + knot_text(state, arguments.number(0)) + " to " + number_text(arguments.number(1));
         }});
    table.push_back({.name = "delete-knot",
                     .title = "Delete knot",
                     .explanation = "Deletes a knot together with the control point that it carries most.",
                     .group = CommandGroup::curve,
                     .submenu = "Knots",
                     .effect = ShapeEffect::changes,
                     .parameters = {{"index", Kind::number, which_knot, selected_knot}},
                     .refusal = no_editable_curve,
                     .edit = delete_knot,
                     .label = [](const EditorState& state, const Arguments& arguments) {
                         return "Delete knot " + knot_text(state, arguments.number(0));
                     }});
}

void add_vectors(std::vector<CommandSpec>& table) {
    table.push_back({.name = "set-knots",
                     .title = "Type knot vector",
                     .explanation = "Replaces all knots; the control points stay.",
                     .group = CommandGroup::curve,
                     .submenu = "Knots",
                     .effect = ShapeEffect::changes,
                     .parameters = {{"knots", Kind::numbers, "all knots in order, or one period of a closed curve"}},
                     .refusal = no_editable_curve,
                     .edit = set_knots});
    table.push_back(
        {.name = "set-kind",
         .title = "Set kind of knots",
         .explanation = "Makes the knots uniform, clamped uniform, Bézier, piecewise Bézier, periodic or custom.",
         .group = CommandGroup::curve,
         .submenu = "Knots",
         .effect = ShapeEffect::changes,
         .parameters = {{"kind", Kind::text, "uniform, clamped-uniform, bezier, piecewise-bezier, periodic or custom"}},
         .refusal = no_editable_curve,
         .edit = set_kind,
         .label = [](const EditorState&, const Arguments& arguments) {
             return std::string(kind_named(arguments.text(0))->label);
         }});
    table.push_back({.name = "toggle-closed",
                     .title = "Closed",
                     .explanation = "Makes the curve a closed, periodic one, or opens it.",
                     .group = CommandGroup::curve,
                     .submenu = "Closing",
                     .effect = ShapeEffect::changes,
                     .refusal = no_editable_curve,
                     .is_checked = is_closed,
                     .edit = toggle_closed,
                     .label = [](const EditorState& state, const Arguments&) {
                         return std::string(active_curve(state).is_periodic() ? "Open curve" : "Close curve");
                     }});
}

}  // namespace

void add_knot_commands(std::vector<CommandSpec>& table) {
    add_insertions(table);
    add_moves(table);
    add_vectors(table);
}

}  // namespace batten::editor
