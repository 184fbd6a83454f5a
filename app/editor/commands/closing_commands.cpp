#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_end_named.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"
#include "core/edit/end_vertices.h"
#include "core/measure/collinear.h"
#include "core/refine/periodic.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;

// Equal parameters need not mean equal places afterwards, so the deviation is what the conversion says.
Outcome<Edit> edit_with_error(const EditorState& state, const core::Result<core::Approximation>& found) {
    if (!found) return tl::unexpected(core::describe(found.error()));
    Outcome<Edit> edit = edit_active(state, found->curve);
    if (edit) edit->error = found->error;
    return edit;
}

Outcome<Edit> to_periodic(const EditorState& state, const Arguments& arguments) {
    return edit_with_error(state, core::to_periodic(active_curve(state), arguments.number(0)));
}

Outcome<Edit> to_wrapped(const EditorState& state, const Arguments& arguments) {
    return edit_with_error(state, core::to_wrapped(active_curve(state), arguments.number(0)));
}

Outcome<Edit> to_clamped(const EditorState& state, const Arguments&) {
    return edit_active(state, core::to_clamped(active_curve(state)));
}

Outcome<Edit> move_seam(const EditorState& state, const Arguments& arguments) {
    return edit_with_error(state, core::move_seam(active_curve(state), arguments.number(0), arguments.number(1)));
}

template <core::EndVertex vertex>
Outcome<Edit> add_end_vertex(const EditorState& state, const Arguments& arguments) {
    const auto add = [](const core::Curve& curve, core::CurveEnd end) {
        return core::add_end_vertex(curve, end, vertex);
    };
    Outcome<core::Curve> curve = change_ends(active_curve(state), arguments.text(0), add);
    if (!curve) return tl::unexpected(curve.error());
    return edit_active(state, *std::move(curve));
}

Outcome<Edit> straighten(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> first = index_of(arguments.number(0), "from");
    if (!first) return tl::unexpected(first.error());
    const Outcome<std::size_t> last = index_of(arguments.number(1), "to");
    if (!last) return tl::unexpected(last.error());
    return edit_active(state, core::straighten(active_curve(state), *first, *last));
}

std::optional<Argument> first_selected(const EditorState& state) {
    if (state.selection.points.empty()) return std::nullopt;
    return static_cast<double>(state.selection.points.front());
}

std::optional<Argument> last_selected(const EditorState& state) {
    if (state.selection.points.empty()) return std::nullopt;
    return static_cast<double>(state.selection.points.back());
}

void add_conversions(std::vector<CommandSpec>& table) {
    const ParameterSpec tolerance{"tolerance", Kind::number, "how far the curve may move, above 0", tiny_length};
    table.push_back({.name = "to-periodic",
                     .title = "Make periodic",
                     .explanation = "Turns a curve whose ends meet, or whose control points are wrapped, into a truly "
                                    "periodic one.",
                     .group = CommandGroup::curve,
                     .submenu = "Closing",
                     .effect = ShapeEffect::changes,
                     .parameters = {tolerance},
                     .refusal = no_editable_curve,
                     .edit = to_periodic});
    table.push_back({.name = "to-wrapped",
                     .title = "Make wrapped",
                     .explanation = "Turns a closed curve into an open one that repeats its first p control points.",
                     .group = CommandGroup::curve,
                     .submenu = "Closing",
                     .effect = ShapeEffect::changes,
                     .parameters = {tolerance},
                     .refusal = no_editable_curve,
                     .edit = to_wrapped});
    table.push_back({.name = "to-clamped",
                     .title = "Make clamped",
                     .explanation = "Opens a periodic curve at its seam, or raises the end knots of an open one; the "
                                    "curve stays as it is.",
                     .group = CommandGroup::curve,
                     .submenu = "Closing",
                     .effect = ShapeEffect::keeps,
                     .refusal = no_editable_curve,
                     .edit = to_clamped});
    table.push_back({.name = "move-seam",
                     .title = "Move seam",
                     .explanation = "Lets a closed curve begin and end at u; a periodic one gains a knot there.",
                     .group = CommandGroup::curve,
                     .submenu = "Closing",
                     .effect = ShapeEffect::changes,
                     .parameters = {{"u", Kind::number, "where in the domain", current_parameter}, tolerance},
                     .refusal = no_editable_curve,
                     .edit = move_seam,
                     .label = [](const EditorState&, const Arguments& arguments) {
                         return "Move seam to " + number_text(arguments.number(0));
                     }});
}

CommandSpec end_command(const char* name, const char* title, const char* explanation,
                        Outcome<Edit> (*edit)(const EditorState&, const Arguments&)) {
    return {.name = name,
            .title = title,
            .explanation = explanation,
            .group = CommandGroup::curve,
            .submenu = "Ends of uniform cubics",
            .effect = ShapeEffect::changes,
            .parameters = {{"end", Kind::text, "start, end or both", both_ends}},
            .refusal = no_editable_curve,
            .edit = edit};
}

void add_ends(std::vector<CommandSpec>& table) {
    table.push_back(end_command("double-end", "Double end vertices",
                                "Repeats the end point of a uniform cubic, which then ends on the last leg without "
                                "curvature.",
                                add_end_vertex<core::EndVertex::doubled>));
    table.push_back(
        end_command("triple-end", "Triple end vertices",
                    "Repeats the end point of a uniform cubic twice, so that the curve ends in it, straight.",
                    add_end_vertex<core::EndVertex::tripled>));
    table.push_back(end_command("phantom-end", "Add phantom end vertices",
                                "Adds a point that mirrors the last but one of a uniform cubic, so that the curve ends "
                                "in its end point without curvature.",
                                add_end_vertex<core::EndVertex::phantom>));
    table.push_back({.name = "straighten",
                     .title = "Straighten between points",
                     .explanation = "Moves the control points between two others onto the line through them, which "
                                    "makes a straight piece.",
                     .group = CommandGroup::curve,
                     .effect = ShapeEffect::changes,
                     .parameters = {{"from", Kind::number, "the number of a control point", first_selected},
                                    {"to", Kind::number, "the number of another one", last_selected}},
                     .refusal = no_editable_curve,
                     .edit = straighten,
                     .label = [](const EditorState&, const Arguments& arguments) {
                         return "Straighten from " + point_text(arguments.number(0)) + " to " +
                                point_text(arguments.number(1));
                     }});
}

}  // namespace

void add_closing_commands(std::vector<CommandSpec>& table) {
    add_conversions(table);
    add_ends(table);
}

}  // namespace batten::editor
