#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_end_named.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"
#include "core/edit/knot_edit.h"
#include "core/edit/knot_merging.h"
#include "core/measure/closing.h"
#include "core/measure/deviation.h"
#include "core/refine/bezier_form.h"
#include "core/refine/clamping.h"
#include "core/refine/knot_refinement.h"
#include "core/refine/knot_removal.h"
#include "core/refine/reparametrize.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;

Outcome<Edit> insert_knots(const EditorState& state, const Arguments& arguments) {
    return edit_active(state, core::refine_knots(active_curve(state), arguments.numbers(0)));
}

// What is wrong when not all knots asked for could be removed: nothing is changed then.
Refusal not_removed(const core::KnotRemoval& removal, double tolerance) {
    return "only " + std::to_string(removal.count) + " of the knots can be removed; one more would make the curve " +
           "deviate by " + number_text(removal.refused.value_or(removal.error)) + ", and " + number_text(tolerance) +
           " is allowed";
}

Outcome<Edit> remove_knot(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> times = index_of(arguments.number(1), "times");
    if (!times) return tl::unexpected(times.error());
    if (*times == 0) return tl::unexpected(Refusal("times is 0; it must be 1 or more"));
    const double tolerance = arguments.number(2);
    core::Result<core::KnotRemoval> removal =
        core::remove_knot(active_curve(state), arguments.number(0), static_cast<int>(*times), tolerance);
    if (!removal) return tl::unexpected(core::describe(removal.error()));
    if (removal->refused) return tl::unexpected(not_removed(*removal, tolerance));
    return edit_active(state, std::move(removal->curve));
}

Outcome<Edit> remove_knots(const EditorState& state, const Arguments& arguments) {
    core::Result<core::KnotRemoval> removal = core::remove_knots(active_curve(state), arguments.number(0));
    if (!removal) return tl::unexpected(core::describe(removal.error()));
    if (removal->count == 0)
        return tl::unexpected("no knot can be removed within a deviation of " + number_text(arguments.number(0)));
    return edit_active(state, std::move(removal->curve));
}

Outcome<Edit> merge_knots(const EditorState& state, const Arguments& arguments) {
    core::Result<core::KnotMerging> merging = core::merge_knots(active_curve(state), arguments.number(0));
    if (!merging) return tl::unexpected(core::describe(merging.error()));
    if (merging->count == 0)
        return tl::unexpected("no two knots are nearer than " + number_text(arguments.number(0)) + " of the domain");
    return edit_active(state, std::move(merging->curve));
}

Outcome<Edit> reparametrize(const EditorState& state, const Arguments& arguments) {
    return edit_active(state, core::reparametrize(active_curve(state), {arguments.number(0), arguments.number(1)}));
}

Outcome<Edit> normalize(const EditorState& state, const Arguments&) {
    return edit_active(state, core::reparametrize(active_curve(state), {0.0, 1.0}));
}

template <core::Result<core::Curve> (*changed)(const core::Curve&, core::CurveEnd),
          core::Result<core::Curve> (*both_changed)(const core::Curve&)>
Outcome<Edit> change_clamping(const EditorState& state, const Arguments& arguments) {
    if (arguments.text(0) == "both") return edit_active(state, both_changed(active_curve(state)));
    Outcome<core::Curve> curve = change_ends(active_curve(state), arguments.text(0), changed);
    if (!curve) return tl::unexpected(curve.error());
    return edit_active(state, *std::move(curve));
}

// Extrapolated control points of high degree lose digits, which must not be passed over in silence.
Outcome<Edit> unclamp(const EditorState& state, const Arguments& arguments) {
    Outcome<Edit> edit = change_clamping<core::unclamp, core::unclamp_ends>(state, arguments);
    if (!edit) return edit;
    const core::Curve& curve = active_curve(state);
    const double deviation = core::largest_deviation(curve, *edit->document.active_curve()->curve);
    if (deviation > core::absolute_tolerance(curve, 1e-12)) edit->error = deviation;
    return edit;
}

Outcome<Edit> make_uniform(const EditorState& state, const Arguments&) {
    return edit_active(state, core::make_uniform(active_curve(state)));
}

Outcome<Edit> to_bezier(const EditorState& state, const Arguments&) {
    return edit_active(state, core::to_bezier(active_curve(state)));
}

std::optional<Argument> selected_knot_value(const EditorState& state) {
    const std::optional<std::size_t> knot = state.selection.knot;
    if (!knot || state.history.present().active_curve() == nullptr) return std::nullopt;
    return active_curve(state).knots().stored()[*knot];
}

std::optional<Argument> once(const EditorState&) {
    return 1.0;
}

std::optional<Argument> billionth(const EditorState&) {
    return 1e-9;
}

CommandSpec knot_command(const char* name, const char* title, const char* explanation, ShapeEffect effect,
                         std::vector<ParameterSpec> parameters,
                         Outcome<Edit> (*edit)(const EditorState&, const Arguments&)) {
    return {.name = name,
            .title = title,
            .explanation = explanation,
            .group = CommandGroup::curve,
            .submenu = "Knots",
            .effect = effect,
            .parameters = std::move(parameters),
            .refusal = no_editable_curve,
            .edit = edit};
}

void add_counts_of_knots(std::vector<CommandSpec>& table) {
    const ParameterSpec tolerance{"tolerance", Kind::number, "how far the curve may move, above 0", tiny_length};
    table.push_back(knot_command(
        "insert-knots", "Insert knots", "Inserts many knots at once; the curve stays as it is.", ShapeEffect::keeps,
        {{"knots", Kind::numbers, "where in the domain, in any order; repeats count"}}, insert_knots));
    table.push_back(knot_command("remove-knot", "Remove knot",
                                 "Removes a knot, where the curve hardly needs it; otherwise nothing changes.",
                                 ShapeEffect::changes,
                                 {{"u", Kind::number, "the value of the knot", selected_knot_value},
                                  {"times", Kind::number, "how often", once},
                                  tolerance},
                                 remove_knot));
    table.back().label = [](const EditorState&, const Arguments& arguments) {
        return "Remove knot " + number_text(arguments.number(0));
    };
    table.push_back(knot_command("remove-knots", "Remove all spare knots",
                                 "Removes as many knots as the curve can spare, those that matter least first.",
                                 ShapeEffect::changes, {tolerance}, remove_knots));
    table.push_back(knot_command("merge-knots", "Merge near knots",
                                 "Makes knots equal that nearly are; the control points stay.", ShapeEffect::changes,
                                 {{"tolerance", Kind::number, "how near, as a part of the domain, above 0", billionth}},
                                 merge_knots));
    table.push_back(knot_command("to-bezier", "Raise all knots to Bézier form",
                                 "Raises every knot to the multiplicity p, so that the control points are those of the "
                                 "Bézier pieces; the curve stays as it is.",
                                 ShapeEffect::keeps, {}, to_bezier));
}

void add_changes_of_parameter(std::vector<CommandSpec>& table) {
    table.push_back(
        knot_command("reparametrize", "Set domain",
                     "Stretches and shifts all knots so that the domain begins and ends as asked; the "
                     "curve stays as it is.",
                     ShapeEffect::keeps,
                     {{"a", Kind::number, "where the domain begins"}, {"b", Kind::number, "where it ends, above a"}},
                     reparametrize));
    table.back().label = [](const EditorState&, const Arguments& arguments) {
        return "Set domain to [" + number_text(arguments.number(0)) + ", " + number_text(arguments.number(1)) + "]";
    };
    table.push_back(knot_command("normalize", "Normalize domain",
                                 "Stretches and shifts all knots so that the domain runs from 0 to 1; the curve stays "
                                 "as it is.",
                                 ShapeEffect::keeps, {}, normalize));
    table.push_back(knot_command("make-uniform", "Space knots equally",
                                 "Spaces the knots equally over the same domain; the control points stay.",
                                 ShapeEffect::changes, {}, make_uniform));
    const ParameterSpec ends{"end", Kind::text, "start, end or both", both_ends};
    table.push_back(knot_command("clamp", "Clamp ends",
                                 "Lets an open curve begin and end in its end points; the curve stays as it is.",
                                 ShapeEffect::keeps, {ends}, change_clamping<core::clamp, core::clamp_ends>));
    table.push_back(knot_command("unclamp", "Unclamp ends",
                                 "Spreads the knots at the ends of an open curve beyond its domain; the curve stays as "
                                 "it is.",
                                 ShapeEffect::keeps, {ends}, unclamp));
}

}  // namespace

void add_refinement_commands(std::vector<CommandSpec>& table) {
    add_counts_of_knots(table);
    add_changes_of_parameter(table);
}

}  // namespace batten::editor
