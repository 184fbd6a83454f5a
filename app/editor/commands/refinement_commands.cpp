#include "app/editor/commands/refinement_commands.h"

#include <cmath>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/commands/tear_commands.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/refusal.h"
#include "app/editor/words/wording.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/edit/knot_edit.h"
#include "core/edit/knot_merging.h"
#include "core/measure/deviation.h"
#include "core/refine/bezier_form.h"
#include "core/refine/clamping.h"
#include "core/refine/knot_refinement.h"
#include "core/refine/knot_removal.h"
#include "core/refine/reparametrize.h"

namespace batten::editor {

namespace {

using core::sentence;

// Of the size of a curve: the rounding that is worth a word, and that which no longer keeps the shape.
constexpr double least_rounding = 1e-12;
constexpr double largest_rounding = 1e-6;

constexpr const char* how_far = "how far the curve may move, above 0";

Outcome<Edit> insert_knots(const EditorState& state, const InsertKnots& command) {
    return edit_or_tear(state, core::refine_knots(active_curve(state), command.knots, tears_of_active(state)));
}

// What is wrong when not all knots asked for could be removed: nothing is changed then.
Refusal not_removed(const Units& units, const core::KnotRemoval& removal, double tolerance) {
    const double deviation = removal.refused.value_or(removal.error);
    if (!std::isfinite(deviation)) return refusal_words(units, {.code = core::CurveErrorCode::not_computable});
    return sentence({.one = "only one knot can be removed; removing another would change the curve by {deviation}, and "
                            "{tolerance} is allowed",
                     .many = "only {count} knots can be removed; removing another would change the curve by "
                             "{deviation}, and {tolerance} is allowed",
                     .none = "the knot cannot be removed; that would change the curve by {deviation}, and {tolerance} "
                             "is allowed"},
                    static_cast<std::size_t>(removal.count),
                    {{"deviation", length_words(units, deviation)}, {"tolerance", length_words(units, tolerance)}});
}

Outcome<Edit> remove_knot(const EditorState& state, const RemoveKnot& command) {
    core::Result<core::KnotRemoval> removal =
        core::remove_knot(active_curve(state), command.u, command.times, command.tolerance);
    if (!removal) return refused(state, removal.error());
    if (removal->refused) return tl::unexpected(not_removed(units_of(state), *removal, command.tolerance));
    return edit_active(state, std::move(removal->curve));
}

Outcome<Edit> remove_knots(const EditorState& state, const RemoveKnots& command) {
    core::Result<core::KnotRemoval> removal =
        core::remove_knots(active_curve(state), command.tolerance, state.progress);
    if (!removal) return refused(state, removal.error());
    if (removal->count == 0)
        return tl::unexpected(sentence("no knot can be removed within a deviation of {tolerance}",
                                       {{"tolerance", length_words(units_of(state), command.tolerance)}}));
    return edit_active(state, std::move(removal->curve));
}

Outcome<Edit> merge_knots(const EditorState& state, const MergeKnots& command) {
    core::Result<core::KnotMerging> merging = core::merge_knots(active_curve(state), command.tolerance);
    if (!merging) return refused(std::nullopt, merging.error());
    if (merging->count == 0)
        return tl::unexpected(sentence("no two knots are nearer than {tolerance} of the domain",
                                       {{"tolerance", core::shortest_text(command.tolerance)}}));
    return edit_active(state, std::move(merging->curve));
}

std::size_t knots_lost(const EditorState& state, const core::Curve& after) {
    return active_curve(state).knots().stored().size() - after.knots().stored().size();
}

StepTexts texts_of_many(const EditorState& state, const InsertKnots&, const core::Curve& after) {
    const std::size_t count = after.knots().stored().size() - active_curve(state).knots().stored().size();
    return {InsertKnots::spec().title, sentence({.one = "Inserted one knot", .many = "Inserted {count} knots"}, count)};
}

StepTexts texts_of_removal(const EditorState& state, const RemoveKnot& command, const core::Curve& after) {
    const core::Place u("u", core::shortest_text(command.u));
    const int left = after.knots().multiplicity(command.u);
    return {sentence("Remove knot {u}", {u}),
            left == 0
                ? sentence("Removed knot {u}", {u})
                : sentence({.one = "Removed knot {u} once: {words}", .many = "Removed knot {u} {count} times: {words}"},
                           knots_lost(state, after), {u, {"words", knot_words(after, command.u)}})};
}

StepTexts texts_of_sparing(const EditorState& state, const RemoveKnots&, const core::Curve& after) {
    return {RemoveKnots::spec().title,
            sentence({.one = "Removed the only spare knot", .many = "Removed {count} spare knots"},
                     knots_lost(state, after))};
}

// "[0, 4]" of the curve.
core::Place domain_place(const char* name, const core::Curve& curve) {
    const core::Interval domain = curve.domain();
    return {name, sentence("[{lower}, {upper}]", {{"lower", core::shortest_text(domain.lower)},
                                                  {"upper", core::shortest_text(domain.upper)}})};
}

StepTexts texts_of_domain(const EditorState& state, const Reparametrize&, const core::Curve& after) {
    const core::Place to = domain_place("to", after);
    return {sentence("Set domain to {to}", {to}),
            sentence("Set domain from {from} to {to}", {domain_place("from", active_curve(state)), to})};
}

StepTexts texts_of_normalization(const EditorState& state, const Normalize&, const core::Curve& after) {
    return {Normalize::spec().title, sentence("Normalized domain from {from} to {to}",
                                              {domain_place("from", active_curve(state)), domain_place("to", after)})};
}

Outcome<Edit> to_bezier(const EditorState& state, const ToBezier&) {
    return edit_active(state, core::to_bezier(active_curve(state)));
}

Outcome<Edit> reparametrize(const EditorState& state, const Reparametrize& command) {
    return edit_active(state, core::reparametrize(active_curve(state), {command.begin, command.end}));
}

Outcome<Edit> normalize(const EditorState& state, const Normalize&) {
    return edit_active(state, core::reparametrize(active_curve(state), {0.0, 1.0}));
}

Outcome<Edit> make_uniform(const EditorState& state, const MakeUniform&) {
    return edit_active(state, core::make_uniform(active_curve(state)));
}

// Both ends at once are one operation of the core, which cannot stop half-way.
Outcome<Edit> clamp(const EditorState& state, const Clamp& command) {
    const core::Curve& curve = active_curve(state);
    if (command.end == CurveEnds::both) return edit_active(state, core::clamp_ends(curve));
    return edit_active(state, change_ends(curve, command.end, core::clamp));
}

// Extrapolated control points of high degree lose digits, which must not be passed over in silence.
Outcome<Edit> unclamp(const EditorState& state, const Unclamp& command) {
    const core::Curve& curve = active_curve(state);
    Outcome<Edit> edit = command.end == CurveEnds::both
                             ? edit_active(state, core::unclamp_ends(curve))
                             : edit_active(state, change_ends(curve, command.end, core::unclamp));
    if (!edit) return edit;
    const double deviation = core::largest_deviation(curve, *edit->document.active_curve()->curve);
    if (!std::isfinite(deviation)) return refused(state, {.code = core::CurveErrorCode::not_computable});
    if (!is_within_tolerance(curve, deviation, largest_rounding))
        return tl::unexpected(sentence(
            "unclamped, the control points would be so far away that rounding moves the curve by at most {deviation}",
            {{"deviation", length_words(units_of(state), deviation)}}));
    if (!is_within_tolerance(curve, deviation, least_rounding)) edit->error = deviation;
    return edit;
}

template <class Command>
StepTexts texts_of_ends(const Command& command, const char* both, const char* start, const char* end) {
    const char* done = command.end == CurveEnds::both ? both : command.end == CurveEnds::start ? start : end;
    return {Command::spec().title, done};
}

StepTexts texts_of_clamping(const EditorState&, const Clamp& command) {
    return texts_of_ends(command, "Clamped both ends", "Clamped the start", "Clamped the end");
}

StepTexts texts_of_unclamping(const EditorState&, const Unclamp& command) {
    return texts_of_ends(command, "Unclamped both ends", "Unclamped the start", "Unclamped the end");
}

}  // namespace

const CommandSpec& InsertKnots::spec() {
    static const CommandSpec spec{.name = "insert-knots",
                                  .title = "Insert knots",
                                  .explanation = "Inserts several knots at once; the curve stays as it is.",
                                  .synonyms = "refine Oslo",
                                  .group = CommandGroup::curve,
                                  .submenu = "Knots",
                                  .effect = ShapeEffect::keeps,
                                  .fields = {field::parameters<&InsertKnots::knots>(
                                      "knots", "where in the domain, in any order; a value given twice counts twice")},
                                  .refusal = no_editable_curve,
                                  .run = body_of<insert_knots>,
                                  .texts = texts_of<texts_of_many>};
    return spec;
}

const CommandSpec& RemoveKnot::spec() {
    static const CommandSpec spec{
        .name = "remove-knot",
        .title = "Remove knot",
        .explanation = "Removes a knot if the curve stays within a tolerance; otherwise nothing changes.",
        .synonyms = "delete",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::changes,
        .fields =
            {field::parameter<&RemoveKnot::u>("u", "the value of the knot").suggesting<suggest::selected_knot_value>(),
             field::count<&RemoveKnot::times>("times", "how often").usually(1).at_least(1.0),
             field::length<&RemoveKnot::tolerance>("tolerance", how_far).suggesting<suggest::tiny_length>()},
        .refusal = no_editable_curve,
        .run = body_of<remove_knot>,
        .texts = texts_of<texts_of_removal>,
        .tells_smoothness = true};
    return spec;
}

const CommandSpec& RemoveKnots::spec() {
    static const CommandSpec spec{
        .name = "remove-knots",
        .title = "Remove all spare knots",
        .explanation = "Removes as many knots as the curve can spare, those that matter least first.",
        .synonyms = "simplify delete",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::changes,
        .fields = {field::length<&RemoveKnots::tolerance>("tolerance", how_far).suggesting<suggest::tiny_length>()},
        .refusal = no_editable_curve,
        .run = body_of<remove_knots>,
        .at_work = "Removing spare knots",
        .texts = texts_of<texts_of_sparing>,
        .tells_smoothness = true};
    return spec;
}

const CommandSpec& MergeKnots::spec() {
    static const CommandSpec spec{
        .name = "merge-knots",
        .title = "Merge near knots",
        .explanation = "Makes knots equal that are nearly equal; the control points stay.",
        .synonyms = "clean",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::changes,
        .fields = {field::number<&MergeKnots::tolerance>("tolerance", "how near, as a part of the domain, above 0")
                       .usually(1e-9)},
        .refusal = no_editable_curve,
        .run = body_of<merge_knots>,
        .done = "Merged near knots",
        .tells_smoothness = true};
    return spec;
}

const CommandSpec& ToBezier::spec() {
    static const CommandSpec spec{
        .name = "to-bezier",
        .title = "Raise all knots to Bézier form",
        .explanation =
            "Raises every knot to the multiplicity p, so that the control points are those of the Bézier "
            "pieces; the curve stays as it is.",
        .synonyms = "decompose",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::keeps,
        .refusal = no_editable_curve,
        .run = body_of<to_bezier>,
        .done = "Raised all knots to Bézier form"};
    return spec;
}

const CommandSpec& Reparametrize::spec() {
    static const CommandSpec spec{
        .name = "reparametrize",
        .title = "Set domain",
        .explanation =
            "Stretches and shifts all knots so that the domain begins and ends as asked; the curve stays as "
            "it is.",
        .synonyms = "reparametrize scale interval",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::keeps,
        .fields = {field::parameter<&Reparametrize::begin>("a", "where the domain begins")
                       .beginning_with<suggest::domain_begin>(),
                   field::parameter<&Reparametrize::end>("b", "where it ends, above a")
                       .beginning_with<suggest::domain_end>()},
        .refusal = no_editable_curve,
        .run = body_of<reparametrize>,
        .texts = texts_of<texts_of_domain>};
    return spec;
}

const CommandSpec& Normalize::spec() {
    static const CommandSpec spec{
        .name = "normalize",
        .title = "Normalize domain",
        .explanation = "Stretches and shifts all knots so that the domain runs from 0 to 1; the curve stays as it is.",
        .synonyms = "reparametrize",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::keeps,
        .refusal = no_editable_curve,
        .run = body_of<normalize>,
        .texts = texts_of<texts_of_normalization>};
    return spec;
}

const CommandSpec& MakeUniform::spec() {
    static const CommandSpec spec{
        .name = "make-uniform",
        .title = "Space knots equally",
        .explanation = "Spaces the knots equally over the same domain; the control points stay.",
        .synonyms = "uniform",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::changes,
        .refusal = no_editable_curve,
        .run = body_of<make_uniform>,
        .done = "Spaced knots equally"};
    return spec;
}

const CommandSpec& Clamp::spec() {
    static const CommandSpec spec{
        .name = "clamp",
        .title = "Clamp ends",
        .explanation = "Makes an open curve begin and end at its end points; the curve stays as it is.",
        .synonyms = "open",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::keeps,
        .fields = {field::choice<&Clamp::end>("end", "which ends").usually(CurveEnds::both)},
        .refusal = no_editable_curve,
        .run = body_of<clamp>,
        .texts = texts_of<texts_of_clamping>};
    return spec;
}

const CommandSpec& Unclamp::spec() {
    static const CommandSpec spec{
        .name = "unclamp",
        .title = "Unclamp ends",
        .explanation = "Spreads the knots at the ends of an open curve beyond its domain; the curve stays as it is.",
        .synonyms = "float",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::keeps,
        .fields = {field::choice<&Unclamp::end>("end", "which ends").usually(CurveEnds::both)},
        .refusal = no_editable_curve,
        .run = body_of<unclamp>,
        .texts = texts_of<texts_of_unclamping>};
    return spec;
}

void add_refinement_commands(CommandTable& table) {
    add_all<InsertKnots, RemoveKnot, RemoveKnots, MergeKnots, ToBezier>(table);
    add_all<Reparametrize, Normalize, MakeUniform, Clamp, Unclamp>(table);
}

}  // namespace batten::editor
