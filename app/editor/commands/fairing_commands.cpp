#include "app/editor/commands/fairing_commands.h"

#include <algorithm>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/formula.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/edit/fair.h"
#include "core/edit/rebuild.h"
#include "core/edit/refit.h"
#include "core/edit/simplify.h"

namespace batten::editor {

namespace {

using core::sentence;

// The active curve replaced by what stands for it, with how far it really is off; nothing is selected of other points.
Outcome<Edit> replaced_by(const EditorState& state, core::Result<core::Approximation> found) {
    const bool has_same_points =
        found && found->curve.control_points().size() == active_curve(state).control_points().size();
    return edit_active(state, std::move(found), has_same_points ? std::nullopt : std::optional(Selection{}));
}

Outcome<Edit> fair_part(const EditorState& state, const FairPart& command) {
    const core::Interval part{command.from, command.to};
    Outcome<Edit> edit = replaced_by(state, core::fair_part(active_curve(state), part, command.distance, state.progress,
                                                            held_points(*state.history.present().active_curve())));
    if (edit) edit->faired = FairedPart{.part = part, .distance = command.distance, .curve = edit->document.active};
    return edit;
}

Outcome<Edit> rebuild(const EditorState& state, const Rebuild& command) {
    return replaced_by(state, core::rebuild(active_curve(state), command.count, command.degree, state.progress));
}

Outcome<Edit> simplify(const EditorState& state, const Simplify& command) {
    return replaced_by(state, core::simplify(active_curve(state), command.tolerance, state.progress));
}

Outcome<Edit> delete_and_refit(const EditorState& state, const DeleteAndRefit& command) {
    return replaced_by(state,
                       core::delete_points_and_refit(active_curve(state), ascending(command.points), state.progress));
}

StepTexts texts_of_simplifying(const EditorState& state, const Simplify&, const core::Curve& after) {
    const core::Place from("from", active_curve(state).control_points().size());
    const core::Place to("to", after.control_points().size());
    return {"Simplify curve", sentence("Simplified from {from} to {to} control points", {from, to})};
}

StepTexts texts_of_rebuilding(const EditorState& state, const Rebuild& command) {
    const core::Place from("from", active_curve(state).control_points().size());
    const core::Place to("to", command.count);
    const core::Place degree("degree", command.degree);
    return {sentence("Rebuild with {to} control points", {to}),
            sentence("Rebuilt {from} control points as {to} of degree {degree} over even knots", {from, to, degree})};
}

StepTexts texts_of_delete_and_refit(const EditorState&, const DeleteAndRefit& command) {
    const core::Place points("points", points_text(ascending(command.points)));
    return {sentence("Delete {points} and refit", {points}),
            sentence("Deleted {points} and fitted the rest to the old curve", {points})};
}

constexpr double most_rebuilt = 100'000.0;

std::optional<std::size_t> half_as_many_points(const EditorState& state) {
    if (no_curve(state)) return std::nullopt;
    const core::Curve& curve = active_curve(state);
    const std::size_t half = std::min(curve.control_points().size() / 2, static_cast<std::size_t>(most_rebuilt));
    return std::max(half, static_cast<std::size_t>(curve.degree()) + 1);
}

std::optional<int> degree_now(const EditorState& state) {
    return no_curve(state) ? std::nullopt : std::optional(active_curve(state).degree());
}

// A quarter of the domain around the parameter.
std::optional<double> end_of_part(const EditorState& state, double side) {
    if (no_curve(state)) return std::nullopt;
    const core::Interval domain = active_curve(state).domain();
    const double end = state.parameter() + side * domain.length() / 8.0;
    if (!active_curve(state).is_periodic()) return domain.clamp(end);
    // A part that begins before the seam is that of the period after.
    const bool begins_early = state.parameter() - domain.length() / 8.0 < domain.lower;
    return begins_early ? end + domain.length() : end;
}

std::optional<double> begin_of_part(const EditorState& state) {
    return end_of_part(state, -1.0);
}

std::optional<double> finish_of_part(const EditorState& state) {
    return end_of_part(state, 1.0);
}

}  // namespace

const CommandSpec& FairPart::spec() {
    static const CommandSpec spec{
        .name = "fair-part",
        .title = "Fair part",
        .explanation =
            "Makes the curvature vary less between two parameters, within a distance of the old curve; the "
            "rest keeps every bit.",
        .synonyms = "smooth brush",
        .group = CommandGroup::curve,
        .submenu = "Shape",
        .effect = ShapeEffect::changes,
        .fields = {field::parameter<&FairPart::from>("from", "where the part begins").suggesting<begin_of_part>(),
                   field::parameter<&FairPart::to>("to", "where it ends; beyond the seam, too, of a periodic curve")
                       .suggesting<finish_of_part>(),
                   field::length<&FairPart::distance>("distance", "how far the curve may move, above 0")
                       .suggesting<suggest::hundredth_of_size>()},
        .refusal = no_editable_curve,
        .run = body_of<fair_part>,
        .at_work = "Fairing a part of the curve",
        .step = "Fair from u = {from} to {to}",
        .done = "Faired from u = {from} to {to}",
        .tells_smoothness = true};
    return spec;
}

const CommandSpec& Rebuild::spec() {
    static const CommandSpec spec{
        .name = "rebuild",
        .title = "Rebuild curve",
        .explanation = "Gives the curve so many control points over even knots, as near to the old one as they can be.",
        .synonyms = "points degree uniform refit",
        .group = CommandGroup::curve,
        .submenu = "Shape",
        .effect = ShapeEffect::changes,
        .fields = {field::count<&Rebuild::count>("points", "how many control points")
                       .suggesting<half_as_many_points>()
                       .at_least(2.0)
                       .at_most(most_rebuilt),
                   field::count<&Rebuild::degree>("degree", "of the new curve, 1 to 25")
                       .suggesting<degree_now>()
                       .at_least(core::min_degree)
                       .at_most(core::max_degree)},
        .refusal = no_editable_curve,
        .run = body_of<rebuild>,
        .at_work = "Rebuilding the curve",
        .texts = texts_of<texts_of_rebuilding>,
        .tells_smoothness = true};
    return spec;
}

const CommandSpec& Simplify::spec() {
    static const CommandSpec spec{
        .name = "simplify",
        .title = "Simplify curve",
        .explanation = "Takes out as many control points as a tolerance allows, and fits the others to the old curve.",
        .synonyms = "fewer points reduce thin",
        .group = CommandGroup::curve,
        .submenu = "Shape",
        .effect = ShapeEffect::changes,
        .fields = {field::length<&Simplify::tolerance>("tolerance", "how far the curve may move, above 0")
                       .suggesting<suggest::thousandth_of_size>()},
        .refusal = no_editable_curve,
        .run = body_of<simplify>,
        .at_work = "Simplifying the curve",
        .texts = texts_of<texts_of_simplifying>,
        .tells_smoothness = true};
    return spec;
}

const CommandSpec& DeleteAndRefit::spec() {
    static const CommandSpec spec{
        .name = "delete-refit",
        .title = "Delete points and refit",
        .explanation = "Deletes control points, and fits the others to the old curve.",
        .synonyms = "remove dissolve",
        .group = CommandGroup::edit,
        .submenu = "Points",
        .effect = ShapeEffect::changes,
        .fields = {field::point_indices<&DeleteAndRefit::points>("indices", "which control points, counted from 0")
                       .suggesting<suggest::selected_points>()},
        .refusal = no_editable_curve,
        .run = body_of<delete_and_refit>,
        .at_work = "Fitting the curve again",
        .texts = texts_of<texts_of_delete_and_refit>,
        .tells_smoothness = true};
    return spec;
}

void add_fairing_commands(CommandTable& table) {
    add_all<DeleteAndRefit, FairPart, Rebuild, Simplify>(table);
}

}  // namespace batten::editor
