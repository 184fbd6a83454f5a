#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"
#include "core/degree.h"

namespace batten::editor {

namespace {

Outcome<Edit> elevate_degree(const EditorState& state, const Arguments&) {
    return edit_active(state, core::elevate_degree(active_curve(state)));
}

Outcome<Edit> reduce_degree(const EditorState& state, const Arguments&) {
    return edit_active(state, core::reduce_degree(active_curve(state)));
}

Outcome<Edit> set_degree(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> degree = index_of(arguments.number(0), "p");
    if (!degree) return tl::unexpected(degree.error());
    return edit_active(state, core::set_degree(active_curve(state), static_cast<int>(*degree)));
}

std::optional<Refusal> no_higher_degree(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (active_curve(state).degree() < core::max_degree) return std::nullopt;
    return "the degree is " + std::to_string(core::max_degree) + ", the highest allowed";
}

std::optional<Refusal> no_lower_degree(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (active_curve(state).degree() > core::min_degree) return std::nullopt;
    return "the degree is " + std::to_string(core::min_degree) + ", the lowest allowed";
}

}  // namespace

void add_curve_commands(std::vector<CommandSpec>& table) {
    table.push_back(
        {.name = "set-degree",
         .title = "Set degree",
         .explanation = "Gives the same control points another degree; custom knots are raised or lowered instead.",
         .group = CommandGroup::curve,
         .effect = ShapeEffect::changes,
         .parameters = {{"p", ParameterKind::number, "the new degree, 1 to 25"}},
         .refusal = no_editable_curve,
         .edit = set_degree,
         .label = [](const EditorState&, const Arguments& arguments) {
             return "Set degree to " + number_text(arguments.number(0));
         }});
    table.push_back({.name = "elevate-degree",
                     .title = "Raise degree",
                     .explanation = "Raises the degree by one; the curve stays as it is and gains control points.",
                     .group = CommandGroup::curve,
                     .effect = ShapeEffect::keeps,
                     .refusal = no_higher_degree,
                     .edit = elevate_degree,
                     .label = [](const EditorState& state, const Arguments&) {
                         return "Raise degree to " + std::to_string(active_curve(state).degree() + 1);
                     }});
    table.push_back({.name = "reduce-degree",
                     .title = "Lower degree",
                     .explanation = "Lowers the degree by one; the curve changes unless its degree was raised before.",
                     .group = CommandGroup::curve,
                     .effect = ShapeEffect::changes,
                     .refusal = no_lower_degree,
                     .edit = reduce_degree,
                     .label = [](const EditorState& state, const Arguments&) {
                         return "Lower degree to " + std::to_string(active_curve(state).degree() - 1);
                     }});
}

}  // namespace batten::editor
