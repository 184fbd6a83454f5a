#include "app/editor/commands/degree_commands.h"

#include <algorithm>
#include <limits>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/refusal.h"
#include "core/base/degree_range.h"
#include "core/base/sentence.h"
#include "core/curve/knot_analysis.h"
#include "core/refine/degree.h"

namespace batten::editor {

namespace {

using core::sentence;

Outcome<Edit> set_degree(const EditorState& state, const SetDegree& command) {
    return edit_active(state, core::set_degree(active_curve(state), command.degree));
}

Outcome<Edit> elevate(const EditorState& state, const Elevate& command) {
    return edit_active(state, core::elevate_degree(active_curve(state), command.by));
}

Outcome<Edit> reduce(const EditorState& state, const Reduce& command) {
    const double tolerance = command.tolerance.value_or(std::numeric_limits<double>::max());
    core::Result<core::Approximation> reduced =
        core::reduce_degree(active_curve(state), command.by, tolerance, state.progress);
    if (!reduced) return refused(state, reduced.error());
    return edit_active(state, std::move(reduced->curve));
}

// Whether the control points stayed depends on the knots.
StepTexts texts_of_degree(const EditorState& state, const SetDegree& command, const core::Curve& after) {
    const core::Curve& before = active_curve(state);
    const core::Place from("from", before.degree());
    const core::Place degree("degree", command.degree);
    const bool has_same_points = std::ranges::equal(before.control_points(), after.control_points());
    return {sentence("Set degree to {degree}", {degree}),
            has_same_points
                ? sentence("Set degree from {from} to {degree} with the same control points over {kind} knots",
                           {from, degree, {"kind", core::title_of(core::kind_by_values(after.knots()))}})
                : sentence("Set degree from {from} to {degree} with new control points, since the knots are custom",
                           {from, degree})};
}

StepTexts texts_of_elevation(const EditorState& state, const Elevate& command) {
    const int from = active_curve(state).degree();
    const core::Place degree("degree", from + command.by);
    return {sentence("Raise degree to {degree}", {degree}),
            sentence("Raised degree from {from} to {degree}", {{"from", from}, degree})};
}

StepTexts texts_of_reduction(const EditorState& state, const Reduce& command) {
    const int from = active_curve(state).degree();
    const core::Place degree("degree", from - command.by);
    return {sentence("Lower degree to {degree}", {degree}),
            sentence("Lowered degree from {from} to {degree}", {{"from", from}, degree})};
}

std::optional<Refusal> no_higher_degree(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (active_curve(state).degree() < core::max_degree) return std::nullopt;
    return sentence("the degree is {degree}, the highest allowed", {{"degree", core::max_degree}});
}

std::optional<Refusal> no_lower_degree(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (active_curve(state).degree() > core::min_degree) return std::nullopt;
    return sentence("the degree is {degree}, the lowest allowed", {{"degree", core::min_degree}});
}

std::optional<int> current_degree(const EditorState& state) {
    return no_curve(state) ? std::nullopt : std::optional(active_curve(state).degree());
}

}  // namespace

const CommandSpec& SetDegree::spec() {
    static const CommandSpec spec{
        .name = "set-degree",
        .title = "Set degree",
        .explanation = "Gives the same control points another degree; custom knots are raised or lowered instead.",
        .synonyms = "order",
        .group = CommandGroup::curve,
        .submenu = "Degree",
        .effect = ShapeEffect::changes,
        .fields = {field::count<&SetDegree::degree>("p", "the new degree, 1 to 25")
                       .beginning_with<current_degree>()
                       .at_least(core::min_degree)
                       .at_most(core::max_degree)},
        .refusal = no_editable_curve,
        .run = body_of<set_degree>,
        .texts = texts_of<texts_of_degree>};
    return spec;
}

const CommandSpec& Elevate::spec() {
    static const CommandSpec spec{
        .name = "elevate",
        .title = "Raise degree",
        .explanation = "Raises the degree; the curve stays as it is and gains control points.",
        .synonyms = "elevate order increase",
        .group = CommandGroup::curve,
        .submenu = "Degree",
        .effect = ShapeEffect::keeps,
        .fields = {field::count<&Elevate::by>("t", "by how much").usually(1).at_least(1.0)},
        .refusal = no_higher_degree,
        .run = body_of<elevate>,
        .texts = texts_of<texts_of_elevation>};
    return spec;
}

const CommandSpec& Reduce::spec() {
    static const CommandSpec spec{
        .name = "reduce",
        .title = "Lower degree",
        .explanation = "Lowers the degree; the curve changes unless its degree was raised before.",
        .synonyms = "reduce order decrease",
        .group = CommandGroup::curve,
        .submenu = "Degree",
        .effect = ShapeEffect::changes,
        .fields = {field::count<&Reduce::by>("t", "by how much").usually(1).at_least(1.0),
                   field::length<&Reduce::tolerance>("tolerance", "how far the curve may move; none for no limit")
                       .absent_as("0")},
        .refusal = no_lower_degree,
        .run = body_of<reduce>,
        .at_work = "Lowering the degree",
        .texts = texts_of<texts_of_reduction>,
        .tells_smoothness = true};
    return spec;
}

void add_degree_commands(CommandTable& table) {
    add_all<SetDegree, Elevate, Reduce>(table);
}

}  // namespace batten::editor
