#include "app/editor/commands/joint_commands.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/finding_rows.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/joint_report.h"
#include "app/editor/commands/joint_rows.h"
#include "app/editor/commands/other_curve.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "core/base/sentence.h"
#include "core/measure/arc_length.h"
#include "core/measure/nearest.h"
#include "core/refine/blend.h"
#include "core/refine/match.h"

namespace batten::editor {

namespace {

using core::sentence;

// Where the end meets the other curve: at the parameter asked for, at the nearest end, or, where there is none, at the
// nearest place.
struct MatchPlace {
    core::CurveEnd end;
    core::Passing target;
};

core::CurveEnd nearest_end_to(const core::Curve& curve, core::Point place) {
    const auto away = [&](core::CurveEnd end) {
        return core::robust_length(core::point_at(curve, core::parameter_of(curve.domain(), end)) - place);
    };
    return away(core::CurveEnd::start) < away(core::CurveEnd::end) ? core::CurveEnd::start : core::CurveEnd::end;
}

MatchPlace place_of_match(const core::Curve& curve, const core::Curve& other, const Match& command) {
    if (command.at) {
        const double u = other.knots().into_domain(*command.at);
        const core::CurveEnd end = command.end.value_or(nearest_end_to(curve, core::point_at(other, u)));
        return {end, core::passing_toward(other, u, curve, end)};
    }
    const core::JoinedEnds ends = chosen_ends(curve, other, command.end, std::nullopt);
    if (!core::is_closed(other)) return {ends.first, core::passing_beyond(other, ends.second)};
    const core::Point tip = core::point_at(curve, core::parameter_of(curve.domain(), ends.first));
    return {ends.first, core::passing_toward(other, core::nearest_point(other, tip).u, curve, ends.first)};
}

Outcome<Edit> match_end(const EditorState& state, const Match& command) {
    const Outcome<std::size_t> index = other_curve_named(state, command.other);
    if (!index) return tl::unexpected(index.error());
    const core::DocumentCurve& active = *state.history.present().active_curve();
    const core::DocumentCurve& other = state.history.present().curves[*index];
    const MatchPlace place = place_of_match(*active.curve, *other.curve, command);
    const auto matched = core::match(*active.curve, place.end, place.target, command.continuity);
    if (!matched) return tl::unexpected(refusal_of_ends(units_of(state), active, active, matched.error()));
    Outcome<Edit> edit = edit_active(state, matched->curve);
    if (!edit) return edit;
    if (matched->changed.length() > 0.0) edit->error = matched->error;
    edit->remark = match_report(active.name, *matched, active.curve->degree(), command.continuity, units_of(state));
    return edit;
}

Outcome<Edit> blend_between(const EditorState& state, const Blend& command) {
    const Outcome<std::size_t> index = other_curve_named(state, command.other);
    if (!index) return tl::unexpected(index.error());
    const core::DocumentCurve& active = *state.history.present().active_curve();
    const core::DocumentCurve& other = state.history.present().curves[*index];
    const core::JoinedEnds ends = chosen_ends(*active.curve, *other.curve, command.end, command.other_end);
    auto blended = core::blend(*active.curve, *other.curve, ends, {command.continuity, command.tension},
                               {command.other_continuity, command.other_tension});
    if (!blended) return tl::unexpected(refusal_of_ends(units_of(state), active, other, blended.error()));
    return with_curve(state, sentence("{first} to {second}", {{"first", active.name}, {"second", other.name}}),
                      *std::move(blended));
}

StepTexts texts_of_blend(const EditorState& state, const Blend& command, const core::Curve& after) {
    const core::Place other("other", command.other);
    return {sentence("Blend to '{other}'", {other}),
            sentence("Made a blend to '{other}' of degree {degree}, {length} long",
                     {other,
                      {"degree", after.degree()},
                      {"length", length_words(units_of(state), core::arc_length(after).value)}})};
}

Outcome<void> check_joints(EditorState& state, const CheckJoints& command) {
    const core::Document& document = state.history.present();
    const std::vector<core::Joint> joints = joints_of_document(document, command.tolerance);
    std::vector<Finding> rows;
    for (const core::Joint& joint : joints) rows.push_back(joint_row(document, joint));
    return show_rows(state, "Joints", joints_summary(joints), std::move(rows));
}

double near_enough(const EditorState& state) {
    return usual_joint_tolerance(state.history.present());
}

template <auto member>
Field other_field() {
    return field::curve_name<member>("other", "name of the other curve")
        .template suggesting<suggest::next_curve_name>();
}

}  // namespace

const CommandSpec& Match::spec() {
    static const CommandSpec spec{
        .name = "match",
        .title = "Match end",
        .explanation = "Changes an end of the active curve so that it meets another curve, which keeps every bit.",
        .synonyms = "connect meet continuity G1 G2 G3",
        .group = CommandGroup::curve,
        .submenu = "Joints",
        .effect = ShapeEffect::changes,
        .fields = {other_field<&Match::other>(),
                   field::choice<&Match::continuity>("continuity",
                                                     "what agrees there: points, directions, curvatures, "
                                                     "changes of curvature")
                       .usually(core::GeometricContinuity::g2),
                   field::choice<&Match::end>("end", "which end is changed; the nearest where it is left out"),
                   field::number<&Match::at>("at",
                                             "the parameter on the other curve; its nearest end where it is left "
                                             "out")},
        .refusal = no_second_curve_to_edit,
        .run = body_of<match_end>,
        .step = "Match to {other} {continuity}",
        .done = "Matched to {other} {continuity}"};
    return spec;
}

const CommandSpec& Blend::spec() {
    static const CommandSpec spec{
        .name = "blend",
        .title = "Blend",
        .explanation = "Adds a curve between an end of the active curve and one of another; both stay as they are.",
        .synonyms = "connect bridge smooth G1 G2 G3",
        .group = CommandGroup::curve,
        .submenu = "Joints",
        .fields =
            {other_field<&Blend::other>(),
             field::choice<&Blend::continuity>("continuity", "what agrees at the active curve")
                 .usually(core::GeometricContinuity::g2),
             field::choice<&Blend::other_continuity>("other continuity", "and at the other one")
                 .usually(core::GeometricContinuity::g2),
             field::choice<&Blend::end>("end", "of the active curve; the nearest where it is left out"),
             field::choice<&Blend::other_end>("other end", "of the other curve"),
             field::number<&Blend::tension>("tension", "how far the active curve is followed").above(0.0).usually(1.0),
             field::number<&Blend::other_tension>("other tension", "and the other one").above(0.0).usually(1.0)},
        .refusal = no_second_curve,
        .run = body_of<blend_between>,
        .texts = texts_of<texts_of_blend>};
    return spec;
}

const CommandSpec& CheckJoints::spec() {
    static const CommandSpec spec{
        .name = "check-joints",
        .title = "Check joints",
        .explanation =
            "Lists all places where ends of curves meet, and knots where a curve is not smooth, with what "
            "jumps there.",
        .synonyms = "continuity gaps corners report",
        .group = CommandGroup::analyze,
        .submenu = "Find",
        .fields = {field::length<&CheckJoints::tolerance>("tolerance", "how near ends must be to be a joint, above 0")
                       .above(0.0)
                       .suggesting<near_enough>()},
        .refusal = no_curve,
        .run = body_of<check_joints>};
    return spec;
}

void add_joint_commands(CommandTable& table) {
    add_all<Match, Blend, CheckJoints>(table);
}

}  // namespace batten::editor
