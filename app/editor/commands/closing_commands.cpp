#include "app/editor/commands/closing_commands.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/refusal.h"
#include "core/base/sentence.h"
#include "core/edit/end_vertices.h"
#include "core/edit/knot_edit.h"
#include "core/edit/straighten.h"
#include "core/refine/periodic.h"

namespace batten::editor {

namespace {

// Equal parameters need not mean equal places afterward, so the deviation is what the conversion says.
Outcome<Edit> edit_with_error(const EditorState& state, const core::Result<core::Approximation>& found) {
    if (!found) return refused(state, found.error());
    Outcome<Edit> edit = edit_active(state, found->curve);
    if (edit) edit->error = found->error;
    return edit;
}

Outcome<Edit> close_or_open(const EditorState& state, const CloseOrOpen&) {
    const core::Curve& curve = active_curve(state);
    const std::optional<double> tolerance = suggest::tiny_length(state);
    if (!curve.is_periodic() && tolerance)
        if (const auto closed = core::to_periodic(curve, *tolerance)) return edit_with_error(state, closed);
    return edit_active(state, core::set_periodic(curve, !curve.is_periodic()));
}

StepTexts texts_of_closing_or_opening(const EditorState& state, const CloseOrOpen&) {
    if (active_curve(state).is_periodic()) return {"Open curve", "Opened curve"};
    return {"Close curve", "Closed curve"};
}

bool is_periodic(const EditorState& state) {
    const core::Curve* curve = state.active_curve();
    return curve != nullptr && curve->is_periodic();
}

Outcome<Edit> to_periodic(const EditorState& state, const ToPeriodic& command) {
    return edit_with_error(state, core::to_periodic(active_curve(state), command.tolerance));
}

Outcome<Edit> to_wrapped(const EditorState& state, const ToWrapped& command) {
    return edit_with_error(state, core::to_wrapped(active_curve(state), command.tolerance));
}

Outcome<Edit> to_clamped(const EditorState& state, const ToClamped&) {
    return edit_active(state, core::to_clamped(active_curve(state)));
}

Outcome<Edit> move_seam(const EditorState& state, const MoveSeam& command) {
    return edit_with_error(state, core::move_seam(active_curve(state), command.u, command.tolerance));
}

template <class Command, core::EndVertex vertex>
Outcome<Edit> add_end_vertex(const EditorState& state, const Command& command) {
    const auto add = [](const core::Curve& curve, core::CurveEnd end) {
        return core::add_end_vertex(curve, end, vertex);
    };
    Outcome<Edit> edit = edit_active(state, change_ends(active_curve(state), command.end, add));
    if (edit) edit->only_adds = true;
    return edit;
}

Outcome<Edit> share_vertices(const EditorState& state, const ShareVertices& command) {
    const Outcome<std::size_t> index = curve_named(state, command.other);
    if (!index) return tl::unexpected(index.error());
    const core::DocumentCurve& other = state.history.present().curves[*index];
    if (!core::is_uniform_cubic(*other.curve) || other.curve->is_periodic() || other.curve->is_rational())
        return tl::unexpected(core::sentence(
            "'{name}' has no end vertices to share; it must be a uniform cubic, open and with equal weights",
            {{"name", other.name}}));
    return edit_active(state, core::share_end_vertices(active_curve(state), command.end, *other.curve));
}

Outcome<Edit> straighten(const EditorState& state, const Straighten& command) {
    return edit_active(state, core::straighten(active_curve(state), command.from, command.to));
}

template <auto member>
Field tolerance_field() {
    return field::length<member>("tolerance", "how far the curve may move, above 0")
        .template suggesting<suggest::tiny_length>();
}

template <auto member>
Field ends_field() {
    return field::choice<member>("end", "which ends").usually(CurveEnds::both);
}

}  // namespace

const CommandSpec& CloseOrOpen::spec() {
    static const CommandSpec spec{
        .name = "close-or-open",
        .title = "Closed",
        .explanation = "Makes the curve a closed, periodic one, which does not move where its ends meet, or opens it.",
        .synonyms = "close open periodic",
        .group = CommandGroup::curve,
        .submenu = "Closing",
        .effect = ShapeEffect::changes,
        .refusal = no_editable_curve,
        .is_checked = is_periodic,
        .run = body_of<close_or_open>,
        .texts = texts_of<texts_of_closing_or_opening>};
    return spec;
}

const CommandSpec& ToPeriodic::spec() {
    static const CommandSpec spec{
        .name = "to-periodic",
        .title = "Make periodic",
        .explanation = "Turns a curve whose ends meet, or whose control points are wrapped, into a truly periodic one.",
        .synonyms = "close smooth",
        .group = CommandGroup::curve,
        .submenu = "Closing",
        .effect = ShapeEffect::changes,
        .fields = {tolerance_field<&ToPeriodic::tolerance>()},
        .refusal = no_editable_curve,
        .run = body_of<to_periodic>,
        .done = "Made periodic"};
    return spec;
}

const CommandSpec& ToWrapped::spec() {
    static const CommandSpec spec{
        .name = "to-wrapped",
        .title = "Make wrapped",
        .explanation = "Turns a closed curve into an open one that repeats its first p control points.",
        .synonyms = "unwrap",
        .group = CommandGroup::curve,
        .submenu = "Closing",
        .effect = ShapeEffect::changes,
        .fields = {tolerance_field<&ToWrapped::tolerance>()},
        .refusal = no_editable_curve,
        .run = body_of<to_wrapped>,
        .done = "Made wrapped"};
    return spec;
}

const CommandSpec& ToClamped::spec() {
    static const CommandSpec spec{
        .name = "to-clamped",
        .title = "Make clamped",
        .explanation =
            "Opens a periodic curve at its seam, or raises the end knots of an open one; the curve stays as "
            "it is.",
        .synonyms = "open",
        .group = CommandGroup::curve,
        .submenu = "Closing",
        .effect = ShapeEffect::keeps,
        .refusal = no_editable_curve,
        .run = body_of<to_clamped>,
        .done = "Made clamped"};
    return spec;
}

const CommandSpec& MoveSeam::spec() {
    static const CommandSpec spec{
        .name = "move-seam",
        .title = "Move seam",
        .explanation = "Lets a closed curve begin and end at u; a periodic one gains a knot there.",
        .synonyms = "start",
        .group = CommandGroup::curve,
        .submenu = "Closing",
        .effect = ShapeEffect::changes,
        .fields = {field::parameter<&MoveSeam::u>("u", "where in the domain").suggesting<suggest::current_parameter>(),
                   tolerance_field<&MoveSeam::tolerance>()},
        .refusal = no_editable_curve,
        .run = body_of<move_seam>,
        .step = "Move seam to {u}",
        .done = "Moved seam to {u}"};
    return spec;
}

const CommandSpec& DoubleEnd::spec() {
    static const CommandSpec spec{
        .name = "double-end",
        .title = "Double end vertices",
        .explanation = "Repeats the end point of a uniform cubic, which then ends on the last leg without curvature.",
        .group = CommandGroup::curve,
        .submenu = "Ends of uniform cubics",
        .effect = ShapeEffect::changes,
        .fields = {ends_field<&DoubleEnd::end>()},
        .refusal = no_editable_curve,
        .run = body_of<add_end_vertex<DoubleEnd, core::EndVertex::doubled>>,
        .done = "Doubled end vertices ({end}); the old part of the curve stays and new spans lead to its ends"};
    return spec;
}

const CommandSpec& TripleEnd::spec() {
    static const CommandSpec spec{
        .name = "triple-end",
        .title = "Triple end vertices",
        .explanation = "Repeats the end point of a uniform cubic twice, so that the curve ends in it, straight.",
        .group = CommandGroup::curve,
        .submenu = "Ends of uniform cubics",
        .effect = ShapeEffect::changes,
        .fields = {ends_field<&TripleEnd::end>()},
        .refusal = no_editable_curve,
        .run = body_of<add_end_vertex<TripleEnd, core::EndVertex::tripled>>,
        .done = "Tripled end vertices ({end}); the old part of the curve stays and new spans lead to its ends"};
    return spec;
}

const CommandSpec& PhantomEnd::spec() {
    static const CommandSpec spec{
        .name = "phantom-end",
        .title = "Add phantom end vertices",
        .explanation =
            "Adds a point that mirrors the last but one of a uniform cubic, so that the curve ends in its "
            "end point without curvature.",
        .group = CommandGroup::curve,
        .submenu = "Ends of uniform cubics",
        .effect = ShapeEffect::changes,
        .fields = {ends_field<&PhantomEnd::end>()},
        .refusal = no_editable_curve,
        .run = body_of<add_end_vertex<PhantomEnd, core::EndVertex::phantom>>,
        .done = "Added phantom end vertices ({end}); the old part of the curve stays and new spans lead to its ends"};
    return spec;
}

const CommandSpec& ShareVertices::spec() {
    static const CommandSpec spec{
        .name = "share-vertices",
        .title = "Share three vertices",
        .explanation =
            "Moves the three vertices at one end of a uniform cubic onto those at the other end of another one, so "
            "that the two join with C².",
        .synonyms = "join Coons continue connect",
        .group = CommandGroup::curve,
        .submenu = "Ends of uniform cubics",
        .effect = ShapeEffect::changes,
        .fields =
            {field::curve_name<&ShareVertices::other>("other", "name of the other curve")
                 .suggesting<suggest::next_curve_name>(),
             field::choice<&ShareVertices::end>("end", "which end of the active curve").usually(core::CurveEnd::start)},
        .refusal = no_other_curve,
        .run = body_of<share_vertices>,
        .step = "Share three vertices with {other} ({end})",
        .done = "Shared three vertices with {other} ({end}); with equal knot steps the two join with C² there"};
    return spec;
}

const CommandSpec& Straighten::spec() {
    static const CommandSpec spec{
        .name = "straighten",
        .title = "Straighten between points",
        .explanation =
            "Moves the control points between two others onto the line through them, which makes a straight "
            "piece.",
        .synonyms = "collinear line",
        .group = CommandGroup::curve,
        .effect = ShapeEffect::changes,
        .fields = {field::point_index<&Straighten::from>("from", "the number of a control point")
                       .suggesting<suggest::first_selected_point>(),
                   field::point_index<&Straighten::to>("to", "the number of another one")
                       .suggesting<suggest::last_selected_point>()},
        .refusal = no_editable_curve,
        .run = body_of<straighten>,
        .step = "Straighten from {from} to {to}",
        .done = "Straightened from {from} to {to}"};
    return spec;
}

void add_closing_commands(CommandTable& table) {
    add_all<CloseOrOpen, ToPeriodic, ToWrapped, ToClamped, MoveSeam>(table);
    add_all<DoubleEnd, TripleEnd, PhantomEnd, ShareVertices, Straighten>(table);
}

}  // namespace batten::editor
