#include "app/editor/commands/subdivision_commands.h"

#include <cmath>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/insert_at.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/wording.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/curve/knot_analysis.h"
#include "core/measure/polygon_distance.h"
#include "core/refine/knot_insertion.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr std::size_t most_points = 1'000'000;
constexpr std::size_t most_measured_points = 5000;  // their distance takes a hundredth of a second

// How far the control polygon is from the curve, before and after; none where that takes too long or is not known.
std::optional<std::string> distance_remark(const Units& units, const core::Curve& before, const core::Curve& after) {
    if (after.control_points().size() > most_measured_points) return std::nullopt;
    const double old_distance = core::polygon_distance(before);
    const double distance = core::polygon_distance(after);
    if (!std::isfinite(old_distance) || !std::isfinite(distance)) return std::nullopt;
    return sentence("the control polygon is at most {distance} from it now, {old_distance} before",
                    {{"distance", length_words(units, distance)}, {"old_distance", length_words(units, old_distance)}});
}

Outcome<Edit> refine_midpoints(const EditorState& state, const RefineMidpoints& command) {
    const core::Curve& before = active_curve(state);
    const std::size_t spans = core::segment_count(before.knots());
    const double count = static_cast<double>(before.control_points().size()) +
                         static_cast<double>(spans) * (std::exp2(command.rounds) - 1.0);
    if (count > static_cast<double>(most_points))
        return tl::unexpected(sentence("that would make {count} control points; at most {most} are made",
                                       {{"count", core::shortest_text(count)}, {"most", most_points}}));
    core::Result<core::Curve> refined = before;
    for (int round = 0; round < command.rounds && refined; ++round) refined = core::insert_midpoint_knots(*refined);
    Outcome<Edit> edit = edit_active(state, refined);
    if (edit) edit->remark = distance_remark(units_of(state), before, *refined);
    return edit;
}

StepTexts texts_of_rounds(const EditorState& state, const RefineMidpoints& command, const core::Curve& after) {
    const std::size_t count = after.control_points().size() - active_curve(state).control_points().size();
    const core::Place knots("knots", count);
    return {RefineMidpoints::spec().title,
            sentence({.one = "Inserted {knots} knots at the midpoints of all spans, in one round",
                      .many = "Inserted {knots} knots at the midpoints of all spans, in {count} rounds"},
                     static_cast<std::size_t>(command.rounds), {knots})};
}

// What is still to be inserted for Bézier form: the next knot, and how often a knot.
struct Missing {
    std::optional<double> next{};
    std::size_t count = 0;
};

// Every knot of the domain to multiplicity p, from left to right.
Missing missing_knots(const core::KnotVector& knots) {
    Missing missing;
    for (const core::DistinctKnot& knot : core::distinct_knots(knots)) {
        if (!knot.in_domain || knot.multiplicity >= knots.degree()) continue;
        if (!missing.next) missing.next = knot.value;
        missing.count += static_cast<std::size_t>(knots.degree() - knot.multiplicity);
    }
    return missing;
}

Outcome<Edit> insert_for_bezier(const EditorState& state, const InsertForBezier&) {
    const Missing missing = missing_knots(active_curve(state).knots());
    if (!missing.next)
        return tl::unexpected(
            Refusal("every knot has multiplicity p: the control points are those of the Bézier pieces"));
    Outcome<Edit> edit = insert_knot_at(state, *missing.next);
    if (edit)
        edit->remark = sentence({.one = "one more makes all pieces Bézier",
                                 .many = "{count} more make all pieces Bézier",
                                 .none = "now the control points are those of the Bézier pieces"},
                                missing.count - 1);
    return edit;
}

StepTexts texts_of_next(const EditorState& state, const InsertForBezier&, const core::Curve& after) {
    const double next = *missing_knots(active_curve(state).knots()).next;
    const core::Place u("u", core::shortest_text(next));
    return {sentence("Insert knot {u}", {u}),
            sentence("Inserted knot {u}: {words}", {u, {"words", knot_words(after, next)}})};
}

}  // namespace

const CommandSpec& RefineMidpoints::spec() {
    static const CommandSpec spec{
        .name = "refine-midpoints",
        .title = "Insert knots at midpoints in rounds",
        .explanation =
            "Inserts a knot in the middle of every span, again and again; the control polygon comes to the curve, "
            "which stays as it is.",
        .synonyms = "refine subdivide repeat converge",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::keeps,
        .fields =
            {field::count<&RefineMidpoints::rounds>("rounds", "how often").usually(3).at_least(1.0).at_most(20.0)},
        .refusal = no_editable_curve,
        .run = body_of<refine_midpoints>,
        .at_work = "Inserting knots",
        .texts = texts_of<texts_of_rounds>};
    return spec;
}

const CommandSpec& InsertForBezier::spec() {
    static const CommandSpec spec{
        .name = "insert-for-bezier",
        .title = "Insert next knot toward Bézier form",
        .explanation =
            "Inserts, once, the first knot whose multiplicity is below the degree; step by step the control points "
            "become those of the Bézier pieces.",
        .synonyms = "decompose step multiplicity",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::keeps,
        .refusal = no_editable_curve,
        .run = body_of<insert_for_bezier>,
        .texts = texts_of<texts_of_next>};
    return spec;
}

void add_subdivision_commands(CommandTable& table) {
    add_all<RefineMidpoints, InsertForBezier>(table);
}

}  // namespace batten::editor
