#include <limits>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"
#include "core/refine/degree.h"

namespace batten::editor {

namespace {

// A number of degrees, 1 or more.
Outcome<int> steps_of(double value) {
    const Outcome<std::size_t> steps = index_of(value, "t");
    if (!steps) return tl::unexpected(steps.error());
    if (*steps == 0) return tl::unexpected(Refusal("t is 0; it must be 1 or more"));
    return static_cast<int>(*steps);
}

Outcome<Edit> elevate(const EditorState& state, const Arguments& arguments) {
    const Outcome<int> steps = steps_of(arguments.number(0));
    if (!steps) return tl::unexpected(steps.error());
    return edit_active(state, core::elevate_degree(active_curve(state), *steps));
}

Outcome<Edit> reduce(const EditorState& state, const Arguments& arguments) {
    const Outcome<int> steps = steps_of(arguments.number(0));
    if (!steps) return tl::unexpected(steps.error());
    const double limit = arguments.number(1);
    const double tolerance = limit == 0.0 ? std::numeric_limits<double>::max() : limit;
    core::Result<core::Approximation> reduced = core::reduce_degree(active_curve(state), *steps, tolerance);
    if (!reduced) return tl::unexpected(core::describe(reduced.error()));
    return edit_active(state, std::move(reduced->curve));
}

std::optional<Argument> one_degree(const EditorState&) {
    return 1.0;
}

std::optional<Argument> no_limit(const EditorState&) {
    return 0.0;
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
         .submenu = "Degree",
         .effect = ShapeEffect::changes,
         .parameters = {{"p", ParameterKind::number, "the new degree, 1 to 25"}},
         .refusal = no_editable_curve,
         .edit = set_degree,
         .label = [](const EditorState&, const Arguments& arguments) {
             return "Set degree to " + number_text(arguments.number(0));
         }});
    table.push_back({.name = "elevate",
                     .title = "Raise degree",
                     .explanation = "Raises the degree; the curve stays as it is and gains control points.",
                     .group = CommandGroup::curve,
                     .submenu = "Degree",
                     .effect = ShapeEffect::keeps,
                     .parameters = {{"t", ParameterKind::number, "by how much", one_degree}},
                     .refusal = no_higher_degree,
                     .edit = elevate,
                     .label = [](const EditorState& state, const Arguments& arguments) {
                         return "Raise degree to " + number_text(active_curve(state).degree() + arguments.number(0));
                     }});
    table.push_back({.name = "reduce",
                     .title = "Lower degree",
                     .explanation = "Lowers the degree; the curve changes unless its degree was raised before.",
                     .group = CommandGroup::curve,
                     .submenu = "Degree",
                     .effect = ShapeEffect::changes,
                     .parameters = {{"t", ParameterKind::number, "by how much", one_degree},
                                    {"tolerance", ParameterKind::number,
                                     "how far the curve may move; 0 for as far as it takes", no_limit}},
                     .refusal = no_lower_degree,
                     .edit = reduce,
                     .label = [](const EditorState& state, const Arguments& arguments) {
                         return "Lower degree to " + number_text(active_curve(state).degree() - arguments.number(0));
                     }});
}

}  // namespace batten::editor
