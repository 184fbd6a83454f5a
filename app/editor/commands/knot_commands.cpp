#include "app/editor/commands/knot_commands.h"

#include <algorithm>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/insert_at.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/commands/tear_commands.h"
#include "app/editor/commands/typed_knot.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/wording.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/curve/knot_analysis.h"
#include "core/refine/knot_insertion.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr const char* which_knot = "the number of a knot, counted from 0";

Outcome<Edit> insert_knot(const EditorState& state, const InsertKnot& command) {
    return insert_knot_at(state, command.u);
}

StepTexts texts_of_insertion(const EditorState&, const InsertKnot& command, const core::Curve& after) {
    const core::Place u("u", core::shortest_text(command.u));
    return {sentence("Insert knot {u}", {u}),
            sentence("Inserted knot {u}: {words}", {u, {"words", knot_words(after, command.u)}})};
}

Outcome<Edit> insert_midpoints(const EditorState& state, const InsertMidpoints&) {
    return edit_active(state, core::insert_midpoint_knots(active_curve(state)));
}

StepTexts texts_of_midpoints(const EditorState& state, const InsertMidpoints&, const core::Curve& after) {
    const std::size_t count = after.control_points().size() - active_curve(state).control_points().size();
    return {InsertMidpoints::spec().title, sentence({.one = "Inserted one knot, in the middle of the only span",
                                                     .many = "Inserted {count} knots, one in the middle of every span"},
                                                    count)};
}

Outcome<Edit> raise_knot(const EditorState& state, const RaiseKnot& command) {
    return insert_knot_at(state, active_curve(state).knots().stored()[command.index]);
}

StepTexts texts_of_raising(const EditorState& state, const RaiseKnot& command, const core::Curve& after) {
    const double u = active_curve(state).knots().stored()[command.index];
    const core::Place knot("u", core::shortest_text(u));
    return {sentence("Raise knot {u}", {knot}),
            sentence("Raised knot {u}: {words}", {knot, {"words", knot_words(after, u)}})};
}

// Of a stack the knot at the side to which it is moved is taken; knots keep their order.
Selection selection_after_move(const EditorState& state, std::size_t index, double u) {
    const std::span<const double> knots = active_curve(state).knots().stored();
    const double old = knots[index];
    while (u > old && index + 1 < knots.size() && knots[index + 1] == old) ++index;
    while (u < old && index > 0 && knots[index - 1] == old) --index;
    return {state.selection.points, index};
}

core::Result<core::Curve> moved(const EditorState& state, const MoveKnot& command, core::Tears tears) {
    return core::move_knot(active_curve(state), command.index, command.u, command.mode,
                           command.snap_distance.value_or(0.0), tears);
}

Outcome<Edit> move_knot(const EditorState& state, const MoveKnot& command) {
    if (command.mode == core::KnotMove::stop && command.snap_distance)
        return tl::unexpected(Refusal("a knot in the mode 'stop' takes no snap distance; 'snap' does"));
    return edit_active(state, moved(state, command, tears_of_active(state)),
                       selection_after_move(state, command.index, command.u));
}

// Whether the knot would have joined its neighbor in the mode "snap".
bool stops_before_neighbor(const EditorState& state, const MoveKnot& command) {
    MoveKnot joining = command;
    joining.mode = core::KnotMove::snap;
    joining.snap_distance = 0.0;
    const core::Tears tears = tears_of_active(state);
    return command.mode == core::KnotMove::stop && moved(state, command, tears) != moved(state, joining, tears);
}

// Who drags a knot onto a full stack is told why it does not join.
bool stops_before_full_stack(const EditorState& state, const MoveKnot& command) {
    const core::Tears tears = tears_of_active(state);
    return tears == core::Tears::refuse && moved(state, command, tears) != moved(state, command, core::Tears::allow);
}

// Who drags a knot farther than it goes is told where it stopped and why.
const char* pattern_of_move(const EditorState& state, const MoveKnot& command, double reached) {
    if (stops_before_neighbor(state, command))
        return "Moved knot {from} to {to} instead of {u}, up to its neighbor, which it joins where 'snap' is chosen: "
               "{words}";
    if (stops_before_full_stack(state, command))
        return "Moved knot {from} to {to}, up to a full stack, which it joins where 'Allow tears' lets the curve come "
               "apart";
    if (std::abs(reached - command.u) > command.snap_distance.value_or(0.0))
        return command.mode == core::KnotMove::snap
                   ? "Moved knot {from} to {to} instead of {u}, onto its neighbor: {words}"
                   : "Moved knot {from} to {to} instead of {u}, as far as its neighbors let it: {words}";
    return "Moved knot {from} to {to}: {words}";
}

StepTexts texts_of_move(const EditorState& state, const MoveKnot& command, const core::Curve& after) {
    const double from = active_curve(state).knots().stored()[command.index];
    const double to = after.knots().stored()[*selection_after_move(state, command.index, command.u).knot];
    const core::Place old("from", core::shortest_text(from));
    const core::Place now("to", core::shortest_text(to));
    return {
        sentence("Move knot {from} to {to}", {old, now}),
        core::filled_as_needed(pattern_of_move(state, command, to),
                               {old, now, {"u", core::shortest_text(command.u)}, {"words", knot_words(after, to)}})};
}

Outcome<Edit> set_knot(const EditorState& state, const SetKnot& command) {
    if (auto refusal = refusal_of_typed_knot(state, command.index, command.u))
        return tl::unexpected(*std::move(refusal));
    return edit_or_tear(state, core::set_knot(active_curve(state), command.index, command.u, tears_of_active(state)),
                        selection_after_move(state, command.index, command.u));
}

StepTexts texts_of_setting(const EditorState& state, const SetKnot& command, const core::Curve& after) {
    const core::Place from("from", core::shortest_text(active_curve(state).knots().stored()[command.index]));
    const core::Place to("to", core::shortest_text(command.u));
    return {sentence("Set knot {from} to {to}", {from, to}),
            sentence("Set knot {from} to {to}: {words}", {from, to, {"words", knot_words(after, command.u)}})};
}

Outcome<Edit> delete_knot(const EditorState& state, const DeleteKnot& command) {
    return edit_active(state, core::delete_knot(active_curve(state), command.index));
}

StepTexts texts_of_deletion(const EditorState& state, const DeleteKnot& command, const core::Curve& after) {
    return texts_of_deleted_knot(active_curve(state), command.index, after);
}

StepTexts texts_of_typing(const EditorState&, const SetKnots&, const core::Curve& after) {
    return {SetKnots::spec().title,
            sentence("Typed knot vector: {kind}", {{"kind", core::title_of(core::kind_by_values(after.knots()))}})};
}

Outcome<Edit> set_knots(const EditorState& state, const SetKnots& command) {
    return edit_or_tear(state, core::set_knots(active_curve(state), command.knots, tears_of_active(state)));
}

Outcome<Edit> set_kind(const EditorState& state, const SetKind& command) {
    return edit_active(state, core::set_knot_kind(active_curve(state), command.kind));
}

// Values that have a kind by themselves keep it.
StepTexts texts_of_custom(const core::Curve& after) {
    const core::KnotKind kind = core::kind_by_values(after.knots());
    if (kind == core::KnotKind::custom) return {"Make knots custom", "Made knots custom"};
    return {"Keep knots",
            sentence("Kept the values of the knots, which stay {kind}", {{"kind", core::title_of(kind)}})};
}

StepTexts texts_of_kind(const EditorState&, const SetKind& command, const core::Curve& after) {
    switch (command.kind) {
        case core::KnotKind::uniform:
            return {"Make knots uniform", "Made knots uniform"};
        case core::KnotKind::clamped_uniform:
            return {"Make knots clamped uniform", "Made knots clamped uniform"};
        case core::KnotKind::bezier:
            return {"Make curve Bézier", "Made curve Bézier"};
        case core::KnotKind::piecewise_bezier:
            return {"Make curve piecewise Bézier", "Made curve piecewise Bézier"};
        case core::KnotKind::periodic:
            return {"Make knots periodic", "Made knots periodic"};
        case core::KnotKind::custom:
            break;
    }
    return texts_of_custom(after);
}

Outcome<Edit> toggle_closed(const EditorState& state, const ToggleClosed&) {
    const core::Curve& curve = active_curve(state);
    return edit_active(state, core::set_periodic(curve, !curve.is_periodic()));
}

StepTexts texts_of_closing(const EditorState& state, const ToggleClosed&) {
    if (active_curve(state).is_periodic()) return {"Open curve", "Opened curve"};
    return {"Close curve", "Closed curve"};
}

bool is_closed(const EditorState& state) {
    const core::Curve* curve = state.active_curve();
    return curve != nullptr && curve->is_periodic();
}

std::optional<std::vector<double>> stored_knots(const EditorState& state) {
    if (no_curve(state)) return std::nullopt;
    const std::span<const double> knots = active_curve(state).knots().stored();
    return std::vector(knots.begin(), knots.end());
}

std::optional<core::KnotKind> current_kind(const EditorState& state) {
    if (no_curve(state)) return std::nullopt;
    return core::kind_by_values(active_curve(state).knots());
}

core::KnotMove current_knot_move(const EditorState& state) {
    return state.view.knot_move;
}

}  // namespace

const CommandSpec& InsertKnot::spec() {
    static const CommandSpec spec{
        .name = "insert-knot",
        .title = "Insert knot",
        .explanation = "Inserts a knot at u; the curve stays as it is and gains a control point.",
        .synonyms = "refine Boehm add",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::keeps,
        .shortcut = {Key::i, {}},
        .fields =
            {field::parameter<&InsertKnot::u>("u", "where in the domain").suggesting<suggest::current_parameter>()},
        .refusal = no_editable_curve,
        .run = body_of<insert_knot>,
        .texts = texts_of<texts_of_insertion>};
    return spec;
}

const CommandSpec& InsertMidpoints::spec() {
    static const CommandSpec spec{
        .name = "insert-midpoints",
        .title = "Insert knots at all midpoints",
        .explanation = "Inserts a knot in the middle of every span; the curve stays as it is.",
        .synonyms = "refine subdivide",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::keeps,
        .refusal = no_editable_curve,
        .run = body_of<insert_midpoints>,
        .texts = texts_of<texts_of_midpoints>};
    return spec;
}

const CommandSpec& RaiseKnot::spec() {
    static const CommandSpec spec{
        .name = "raise-knot",
        .title = "Raise multiplicity of knot",
        .explanation = "Inserts a knot again at its value; the curve stays as it is.",
        .synonyms = "multiple",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::keeps,
        .fields = {field::knot_index<&RaiseKnot::index>("index", which_knot).suggesting<suggest::selected_knot>()},
        .refusal = no_editable_curve,
        .run = body_of<raise_knot>,
        .texts = texts_of<texts_of_raising>};
    return spec;
}

const CommandSpec& MoveKnot::spec() {
    static const CommandSpec spec{
        .name = "move-knot",
        .title = "Move knot",
        .explanation = "Moves a knot toward u; at its neighbors it stops, pushes them along, or snaps onto them.",
        .synonyms = "drag merge",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::changes,
        .fields =
            {field::knot_index<&MoveKnot::index>("index", which_knot), field::parameter<&MoveKnot::u>("u", "where to"),
             field::choice<&MoveKnot::mode>("mode", "what it does at its neighbors").suggesting<current_knot_move>(),
             field::parameter<&MoveKnot::snap_distance>("snap distance",
                                                        "how close it must come to jump onto another knot")
                 .at_least(0.0)},
        .refusal = no_editable_curve,
        .run = body_of<move_knot>,
        .texts = texts_of<texts_of_move>};
    return spec;
}

const CommandSpec& SetKnot::spec() {
    static const CommandSpec spec{
        .name = "set-knot",
        .title = "Set knot",
        .explanation = "Sets a knot to a value between its neighbors.",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::changes,
        .fields = {field::knot_index<&SetKnot::index>("index", which_knot).suggesting<suggest::selected_knot>(),
                   field::parameter<&SetKnot::u>("u", "its new value")},
        .refusal = no_editable_curve,
        .run = body_of<set_knot>,
        .texts = texts_of<texts_of_setting>};
    return spec;
}

const CommandSpec& DeleteKnot::spec() {
    static const CommandSpec spec{
        .name = "delete-knot",
        .title = "Delete knot",
        .explanation = "Deletes a knot together with the control point it affects most.",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::changes,
        .fields = {field::knot_index<&DeleteKnot::index>("index", which_knot).suggesting<suggest::selected_knot>()},
        .refusal = no_editable_curve,
        .run = body_of<delete_knot>,
        .texts = texts_of<texts_of_deletion>};
    return spec;
}

const CommandSpec& SetKnots::spec() {
    static const CommandSpec spec{
        .name = "set-knots",
        .title = "Type knot vector",
        .explanation = "Replaces all knots; the control points stay.",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::changes,
        .fields = {field::parameters<&SetKnots::knots>("knots", "all knots in order, or one period of a closed curve")
                       .beginning_with<stored_knots>()},
        .refusal = no_editable_curve,
        .run = body_of<set_knots>,
        .texts = texts_of<texts_of_typing>};
    return spec;
}

const CommandSpec& SetKind::spec() {
    static const CommandSpec spec{
        .name = "set-kind",
        .title = "Set kind of knots",
        .explanation = "Makes the knots uniform, clamped uniform, Bézier, piecewise Bézier, periodic or custom.",
        .synonyms = "open non-uniform",
        .group = CommandGroup::curve,
        .submenu = "Knots",
        .effect = ShapeEffect::changes,
        .fields = {field::choice<&SetKind::kind>("kind", "how the knots are spaced").beginning_with<current_kind>()},
        .refusal = no_editable_curve,
        .run = body_of<set_kind>,
        .texts = texts_of<texts_of_kind>};
    return spec;
}

const CommandSpec& ToggleClosed::spec() {
    static const CommandSpec spec{
        .name = "toggle-closed",
        .title = "Close control polygon",
        .explanation = "Makes the control points those of a closed, periodic curve, or opens it.",
        .synonyms = "close open periodic",
        .group = CommandGroup::curve,
        .submenu = "Closing",
        .effect = ShapeEffect::changes,
        .refusal = no_editable_curve,
        .is_checked = is_closed,
        .run = body_of<toggle_closed>,
        .texts = texts_of<texts_of_closing>};
    return spec;
}

void add_knot_commands(CommandTable& table) {
    add_all<InsertKnot, InsertMidpoints, RaiseKnot, MoveKnot, SetKnot, DeleteKnot, SetKnots, SetKind, ToggleClosed>(
        table);
}

}  // namespace batten::editor
