#include "app/editor/commands/piece_commands.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/joint_report.h"
#include "app/editor/commands/other_curve.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/refusal.h"
#include "core/base/sentence.h"
#include "core/measure/arc_length.h"
#include "core/measure/continuity.h"
#include "core/refine/bezier_form.h"
#include "core/refine/extend.h"
#include "core/refine/reverse.h"
#include "core/refine/split.h"

namespace batten::editor {

namespace {

using core::sentence;

Outcome<Edit> with_parts_of_active(const EditorState& state, core::Result<std::vector<core::Curve>> parts) {
    if (!parts) return refused(state, parts.error());
    return with_parts(state, *std::move(parts));
}

Outcome<Edit> split(const EditorState& state, const Split& command) {
    return with_parts_of_active(state, core::split(active_curve(state), command.u));
}

Outcome<Edit> sub_curve(const EditorState& state, const SubCurve& command) {
    return edit_active(state, core::sub_curve(active_curve(state), command.begin, command.end));
}

Outcome<Edit> bezier_pieces(const EditorState& state, const BezierPieces&) {
    return with_parts_of_active(state, core::bezier_curves(active_curve(state)));
}

core::Result<core::JoinedCurve> joined_as_asked(const core::Curve& active, const core::Curve& other,
                                                const Join& command) {
    if (!command.end && !command.other_end) return core::join(active, other, command.continuity);
    return core::join(active, other, command.continuity, chosen_ends(active, other, command.end, command.other_end));
}

Outcome<Edit> join(const EditorState& state, const Join& command) {
    const Outcome<std::size_t> other = editable_other_curve(state, command.other);
    if (!other) return tl::unexpected(other.error());
    const core::DocumentCurve& active = *state.history.present().active_curve();
    const core::DocumentCurve& second = state.history.present().curves[*other];
    const core::Result<core::JoinedCurve> joined = joined_as_asked(*active.curve, *second.curve, command);
    if (!joined) return tl::unexpected(refusal_of_ends(units_of(state), active, second, joined.error()));
    Edit edit = with_one_for_several(state, joined->curve, {*other});
    if (joined->changed.length() > 0.0) edit.error = joined->error;
    edit.remark = join_report(second.name, *joined, active.curve->degree(), units_of(state));
    return edit;
}

// All curves of the document, in order, from the active one on.
Outcome<Edit> join_pieces(const EditorState& state, const JoinPieces& command) {
    const core::Document& document = state.history.present();
    std::vector<core::Curve> pieces;
    std::vector<std::size_t> others;
    for (std::size_t i = document.active; i < document.curves.size(); ++i) {
        if (std::optional<Refusal> refusal = locked(document.curves[i])) return tl::unexpected(*std::move(refusal));
        pieces.push_back(*document.curves[i].curve);
        if (i != document.active) others.push_back(i);
    }
    core::Result<core::Approximation> joined = core::join_pieces(pieces, command.tolerance);
    if (!joined) return refused(state, joined.error());
    Edit edit = with_one_for_several(state, std::move(joined->curve), others);
    edit.error = joined->error;
    return edit;
}

Outcome<Edit> reverse(const EditorState& state, const Reverse&) {
    return edit_active(state, core::reverse(active_curve(state)));
}

Outcome<Edit> extend(const EditorState& state, const Extend& command) {
    return edit_active(state, core::extend_length(active_curve(state), command.end, command.length));
}

Outcome<Edit> extend_parameter(const EditorState& state, const ExtendParameter& command) {
    auto longer = core::extend_parameter(active_curve(state), command.end, command.by);
    if (!longer) return refused(std::nullopt, longer.error());
    return edit_active(state, std::move(longer));
}

Outcome<Edit> extend_straight(const EditorState& state, const ExtendStraight& command) {
    return edit_active(state, core::extend_straight(active_curve(state), command.end, command.length));
}

std::optional<double> tenth_of_domain(const EditorState& state) {
    return no_curve(state) ? std::nullopt : std::optional(0.1 * active_curve(state).domain().length());
}

std::optional<double> tenth_of_length(const EditorState& state) {
    return no_curve(state) ? std::nullopt : std::optional(0.1 * core::arc_length(active_curve(state)).value);
}

template <auto member>
Field end_field() {
    return field::choice<member>("end", "at which end").usually(core::CurveEnd::end);
}

}  // namespace

const CommandSpec& Split::spec() {
    static const CommandSpec spec{
        .name = "split",
        .title = "Split",
        .explanation = "Cuts the curve in two at u; a periodic one is opened there.",
        .synonyms = "cut divide",
        .group = CommandGroup::curve,
        .submenu = "Pieces",
        .effect = ShapeEffect::keeps,
        .fields = {field::parameter<&Split::u>("u", "where in the domain").suggesting<suggest::current_parameter>()},
        .refusal = no_editable_curve,
        .run = body_of<split>,
        .step = "Split at {u}",
        .done = "Split at {u}"};
    return spec;
}

const CommandSpec& SubCurve::spec() {
    static const CommandSpec spec{
        .name = "sub-curve",
        .title = "Keep only a part",
        .explanation =
            "Keeps the part between two parameters, clamped at both ends; on a periodic curve it may cross "
            "the seam.",
        .synonyms = "trim crop",
        .group = CommandGroup::curve,
        .submenu = "Pieces",
        .fields =
            {field::parameter<&SubCurve::begin>("a", "where the part begins").beginning_with<suggest::domain_begin>(),
             field::parameter<&SubCurve::end>("b", "where it ends").beginning_with<suggest::domain_end>()},
        .refusal = no_editable_curve,
        .run = body_of<sub_curve>,
        .step = "Keep part from {a} to {b}",
        .done = "Kept part from {a} to {b}"};
    return spec;
}

const CommandSpec& BezierPieces::spec() {
    static const CommandSpec spec{.name = "bezier-pieces",
                                  .title = "Split into Bézier pieces",
                                  .explanation = "Makes every span a Bézier curve of its own.",
                                  .synonyms = "decompose",
                                  .group = CommandGroup::curve,
                                  .submenu = "Pieces",
                                  .effect = ShapeEffect::keeps,
                                  .refusal = no_editable_curve,
                                  .run = body_of<bezier_pieces>,
                                  .done = "Split into Bézier pieces"};
    return spec;
}

const CommandSpec& Join::spec() {
    static const CommandSpec spec{
        .name = "join",
        .title = "Join",
        .explanation =
            "Continues the active curve with another one at the ends that are nearest; that one is turned where "
            "needed, "
            "and only a short part of it is changed to meet.",
        .synonyms = "connect merge concatenate",
        .group = CommandGroup::curve,
        .submenu = "Pieces",
        .effect = ShapeEffect::changes,
        .fields =
            {field::curve_name<&Join::other>("other", "name of the other curve").suggesting<suggest::next_curve_name>(),
             field::choice<&Join::continuity>("continuity", "how smooth the joint becomes")
                 .usually(core::JoinContinuity::g1),
             field::choice<&Join::end>("end", "of the active curve; the nearest where it is left out"),
             field::choice<&Join::other_end>("other end", "of the other curve")},
        .refusal = no_other_curve,
        .run = body_of<join>,
        .step = "Join with {other} {continuity}",
        .done = "Joined with {other} {continuity}"};
    return spec;
}

const CommandSpec& JoinPieces::spec() {
    static const CommandSpec spec{
        .name = "join-pieces",
        .title = "Join pieces",
        .explanation =
            "Makes one curve of the active one and all behind it in the list, each beginning where the one "
            "before ends, and removes the knots that are not needed.",
        .synonyms = "connect merge compose",
        .group = CommandGroup::curve,
        .submenu = "Pieces",
        .effect = ShapeEffect::changes,
        .fields = {field::length<&JoinPieces::tolerance>("tolerance", "how far the result may deviate, above 0")
                       .suggesting<suggest::tiny_length>()},
        .refusal = no_other_curve,
        .run = body_of<join_pieces>,
        .done = "Joined pieces"};
    return spec;
}

const CommandSpec& Reverse::spec() {
    static const CommandSpec spec{.name = "reverse",
                                  .title = "Reverse",
                                  .explanation = "Runs through the curve the other way; the domain stays the same.",
                                  .synonyms = "flip direction turn",
                                  .group = CommandGroup::curve,
                                  .submenu = "Pieces",
                                  .effect = ShapeEffect::keeps,
                                  .refusal = no_editable_curve,
                                  .run = body_of<reverse>,
                                  .step = "Reverse direction",
                                  .done = "Reversed direction"};
    return spec;
}

const CommandSpec& Extend::spec() {
    static const CommandSpec spec{
        .name = "extend",
        .title = "Extend by arc length",
        .explanation = "Lets the last piece go on as the polynomial it is; the old part stays.",
        .synonyms = "longer",
        .group = CommandGroup::curve,
        .submenu = "Pieces",
        .fields =
            {field::length<&Extend::length>("length", "along the new part, above 0").suggesting<tenth_of_length>(),
             end_field<&Extend::end>()},
        .refusal = no_editable_curve,
        .run = body_of<extend>,
        .done = "Extended by arc length"};
    return spec;
}

const CommandSpec& ExtendParameter::spec() {
    static const CommandSpec spec{
        .name = "extend-parameter",
        .title = "Extend by parameter",
        .explanation = "Makes the domain longer; the last piece goes on as the polynomial it is.",
        .synonyms = "longer",
        .group = CommandGroup::curve,
        .submenu = "Pieces",
        .fields =
            {field::parameter<&ExtendParameter::by>("by", "how much longer, above 0").suggesting<tenth_of_domain>(),
             end_field<&ExtendParameter::end>()},
        .refusal = no_editable_curve,
        .run = body_of<extend_parameter>,
        .done = "Extended by parameter"};
    return spec;
}

const CommandSpec& ExtendStraight::spec() {
    static const CommandSpec spec{
        .name = "extend-straight",
        .title = "Extend straight on",
        .explanation = "Adds a straight piece in the direction of the end.",
        .synonyms = "longer line",
        .group = CommandGroup::curve,
        .submenu = "Pieces",
        .fields =
            {field::length<&ExtendStraight::length>("length", "of the new part, above 0").suggesting<tenth_of_length>(),
             end_field<&ExtendStraight::end>()},
        .refusal = no_editable_curve,
        .run = body_of<extend_straight>,
        .done = "Extended straight on"};
    return spec;
}

void add_piece_commands(CommandTable& table) {
    add_all<Split, SubCurve, BezierPieces, Join, JoinPieces>(table);
    add_all<Reverse, Extend, ExtendParameter, ExtendStraight>(table);
}

}  // namespace batten::editor
