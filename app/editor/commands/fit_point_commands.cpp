#include "app/editor/commands/fit_point_commands.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/fit_curve.h"
#include "app/editor/words/refusal.h"
#include "app/editor/words/wording.h"
#include "core/base/sentence.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr const char* which_fit_point = "the number of a fit point, counted from 0";

const core::FitPoints& active_fit(const EditorState& state) {
    return *state.history.present().active_curve()->fit;
}

std::optional<Refusal> no_fit_points(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (is_made_of_points(state)) return std::nullopt;
    return "this curve is not made of fit points; 'Curve through points' and the pen make such curves";
}

Outcome<Edit> edit_fit(const EditorState& state, core::Result<core::FitPoints> fit,
                       std::optional<Selection> selection = {}) {
    Edit edit{state.history.present(), std::move(selection)};
    const auto set = std::move(fit).and_then(
        [&](core::FitPoints points) { return set_fit(edit.document.curves[edit.document.active], std::move(points)); });
    if (!set) return refused(state, set.error());
    return edit;
}

Selection only_fit_point(std::size_t index) {
    return {{}, {}, index};
}

Outcome<Edit> move_fit_point(const EditorState& state, const MoveFitPoint& command) {
    return with_fit_point_at(state, command.index, command.position);
}

StepTexts texts_of_moved_fit_point(const EditorState& state, const MoveFitPoint& command) {
    const core::Place index("index", command.index);
    return {sentence("Move fit point {index}", {index}),
            sentence("Moved fit point {index} from {from} to {to}",
                     {index,
                      {"from", place_words(units_of(state), active_fit(state).points[command.index].place)},
                      {"to", place_words(units_of(state), command.position)}})};
}

Outcome<Edit> insert_fit_point(const EditorState& state, const InsertFitPoint& command) {
    const bool is_seam = active_fit(state).closed && command.index == 0;
    return edit_fit(state, core::insert_fit_point(active_fit(state), command.index, command.position),
                    only_fit_point(is_seam ? active_fit(state).points.size() : command.index));
}

Outcome<Edit> delete_fit_point(const EditorState& state, const DeleteFitPoint& command) {
    return without_fit_point(state, command.index);
}

// The derivative that the curve has at the point, from the side on which there is a curve.
core::Vector present_handle(const EditorState& state, std::size_t i) {
    const core::FitPoints& fit = active_fit(state);
    if (fit.points[i].joint == core::FitJoint::tangent) return fit.points[i].handle;
    const bool is_last = !fit.closed && i + 1 == fit.points.size();
    const auto d =
        core::derivatives_at(active_curve(state), fit.parameters[i], 1, is_last ? core::Side::left : core::Side::right);
    return core::handle_of_derivative(fit, i, d[1]);
}

Outcome<Edit> set_fit_joint(const EditorState& state, const SetFitJoint& command) {
    const core::FitPoints& fit = active_fit(state);
    core::Vector handle = command.handle.value_or(core::Vector(0.0, 0.0));
    const bool takes_present =
        command.joint == core::FitJoint::tangent && !command.handle && command.index < fit.points.size();
    if (takes_present) handle = present_handle(state, command.index);
    return edit_fit(state, core::set_fit_joint(fit, command.index, command.joint, handle));
}

StepTexts texts_of_joint(const EditorState& state, const SetFitJoint& command) {
    const core::Place index("index", command.index);
    if (command.joint == core::FitJoint::tangent && command.handle)
        return {sentence("Turn tangent at fit point {index}", {index}),
                sentence("Set handle of fit point {index} to {handle}",
                         {index, {"handle", place_words(units_of(state), core::tip_of(*command.handle))}})};
    const core::Place joint("joint", core::title_of(command.joint));
    return {sentence("Set joint of fit point {index}", {index}),
            sentence("Set joint of fit point {index} to '{joint}'", {index, joint})};
}

Outcome<Edit> set_fit_kind(const EditorState& state, const SetFitKind& command) {
    return edit_fit(state,
                    core::set_fit_form(active_fit(state), {command.kind, command.parametrization, command.closed}));
}

Outcome<Edit> make_ordinary(const EditorState& state, const MakeOrdinary&) {
    Edit edit{state.history.present(), Selection{}};
    core::DocumentCurve& entry = edit.document.curves[edit.document.active];
    entry.fit.reset();
    entry.unknown_fit_members.clear();
    return edit;
}

Outcome<void> select_fit_point(EditorState& state, const SelectFitPoint& command) {
    if (command.index && *command.index >= active_fit(state).points.size())
        return refused(state, {.code = core::CurveErrorCode::fit_point_index_out_of_range,
                               .index = *command.index,
                               .upper = static_cast<double>(active_fit(state).points.size()) - 1.0});
    state.selection = {{}, {}, command.index};
    return {};
}

std::optional<Refusal> no_selected_fit_point(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_fit_points(state)) return refusal;
    if (state.selection.fit_point) return std::nullopt;
    return "no fit point is selected";
}

template <core::FitJoint joint>
Outcome<Edit> join_at(const EditorState& state, const JoinAt<joint>&) {
    return set_fit_joint(state, {.index = *state.selection.fit_point, .joint = joint});
}

template <core::FitJoint joint>
StepTexts texts_of_join_at(const EditorState& state, const JoinAt<joint>&) {
    return texts_of_joint(state, {.index = *state.selection.fit_point, .joint = joint});
}

template <core::FitJoint joint>
bool is_joined(const EditorState& state) {
    if (no_selected_fit_point(state) || *state.selection.fit_point >= active_fit(state).points.size()) return false;
    return active_fit(state).points[*state.selection.fit_point].joint == joint;
}

template <core::FitJoint joint>
CommandSpec joining(const char* name, const char* title, const char* explanation) {
    return {.name = name,
            .title = title,
            .explanation = explanation,
            .synonyms = "fit point joint",
            .group = CommandGroup::edit,
            .submenu = "Fit points",
            .offered = in_the_window,
            .effect = ShapeEffect::changes,
            .refusal = no_selected_fit_point,
            .is_checked = is_joined<joint>,
            .run = body_of<join_at<joint>>,
            .texts = texts_of<texts_of_join_at<joint>>};
}

std::optional<std::size_t> selected_fit_point(const EditorState& state) {
    return state.selection.fit_point;
}

// What the fields of the kind begin with; none where there are no fit points.
template <auto member>
auto present(const EditorState& state) {
    using Value = std::remove_cvref_t<decltype(std::declval<core::FitPoints>().*member)>;
    return is_made_of_points(state) ? std::optional<Value>(active_fit(state).*member) : std::nullopt;
}

template <class Command>
Field index_of_fit_point() {
    return field::count<&Command::index>("index", which_fit_point).template beginning_with<selected_fit_point>();
}

}  // namespace

Outcome<Edit> with_fit_point_at(const EditorState& state, std::size_t index, core::Point position) {
    return edit_fit(state, core::move_fit_point(active_fit(state), index, position));
}

Outcome<Edit> without_fit_point(const EditorState& state, std::size_t index) {
    return edit_fit(state, core::delete_fit_point(active_fit(state), index), Selection{});
}

StepTexts texts_of_deleted_fit_point(std::size_t index) {
    return {sentence("Delete fit point {index}", {{"index", index}}),
            sentence("Deleted fit point {index}", {{"index", index}})};
}

const CommandSpec& MoveFitPoint::spec() {
    static const CommandSpec spec{
        .name = "move-fit-point",
        .title = "Move fit point",
        .explanation = "Moves a point that the curve passes.",
        .synonyms = "through",
        .group = CommandGroup::edit,
        .submenu = "Fit points",
        .effect = ShapeEffect::changes,
        .fields = {index_of_fit_point<MoveFitPoint>(),
                   field::position<&MoveFitPoint::position>({"x", "its new x"}, {"y", "its new y"})},
        .refusal = no_fit_points,
        .run = body_of<editor::move_fit_point>,
        .texts = texts_of<texts_of_moved_fit_point>};
    return spec;
}

const CommandSpec& InsertFitPoint::spec() {
    static const CommandSpec spec{
        .name = "insert-fit-point",
        .title = "Insert fit point",
        .explanation = "Puts in a further point for the curve to pass, before another one or at the end.",
        .synonyms = "add through",
        .group = CommandGroup::edit,
        .submenu = "Fit points",
        .effect = ShapeEffect::changes,
        .fields = {field::count<&InsertFitPoint::index>("index", "the number that the new point will have"),
                   field::position<&InsertFitPoint::position>({"x", "its x"}, {"y", "its y"})},
        .refusal = no_fit_points,
        .run = body_of<editor::insert_fit_point>,
        .step = "Insert fit point {index}",
        .done = "Inserted fit point {index} at ({x}, {y})"};
    return spec;
}

const CommandSpec& DeleteFitPoint::spec() {
    static const CommandSpec spec{.name = "delete-fit-point",
                                  .title = "Delete fit point",
                                  .explanation = "Takes out a point that the curve passes.",
                                  .synonyms = "remove through",
                                  .group = CommandGroup::edit,
                                  .submenu = "Fit points",
                                  .effect = ShapeEffect::changes,
                                  .fields = {index_of_fit_point<DeleteFitPoint>()},
                                  .refusal = no_fit_points,
                                  .run = body_of<editor::delete_fit_point>,
                                  .step = "Delete fit point {index}",
                                  .done = "Deleted fit point {index}"};
    return spec;
}

const CommandSpec& SetFitJoint::spec() {
    static const CommandSpec spec{
        .name = "set-fit-joint",
        .title = "Set joint of fit point",
        .explanation =
            "Says what the curve does at a point that it passes: smooth, along a handle, a corner, or "
            "straight on.",
        .synonyms = "corner tangent handle straight smooth",
        .group = CommandGroup::edit,
        .submenu = "Fit points",
        .effect = ShapeEffect::changes,
        .fields = {index_of_fit_point<SetFitJoint>(),
                   field::choice<&SetFitJoint::joint>("joint", "what the curve does there"),
                   field::vector<&SetFitJoint::handle>({"dx",
                                                        "x of the handle of a given tangent, a third of the derivative "
                                                        "over a span; left out, it begins as the curve runs"},
                                                       {"dy", "y of that handle"})},
        .refusal = no_fit_points,
        .run = body_of<editor::set_fit_joint>,
        .texts = texts_of<texts_of_joint>};
    return spec;
}

template <>
const CommandSpec& JoinAt<core::FitJoint::smooth>::spec() {
    static const CommandSpec spec = joining<core::FitJoint::smooth>(
        "make-fit-point-smooth", "Smooth", "Lets the curve run smoothly through the selected fit point.");
    return spec;
}

template <>
const CommandSpec& JoinAt<core::FitJoint::tangent>::spec() {
    static const CommandSpec spec = joining<core::FitJoint::tangent>(
        "give-fit-point-tangent", "Tangent by handle",
        "Gives the selected fit point a handle, along which the curve leaves; it begins as the curve runs.");
    return spec;
}

template <>
const CommandSpec& JoinAt<core::FitJoint::corner>::spec() {
    static const CommandSpec spec =
        joining<core::FitJoint::corner>("make-fit-point-corner", "Corner", "Makes a corner at the selected fit point.");
    return spec;
}

template <>
const CommandSpec& JoinAt<core::FitJoint::straight>::spec() {
    static const CommandSpec spec = joining<core::FitJoint::straight>(
        "make-fit-point-straight", "Straight to the next",
        "Leads the curve straight from the selected fit point to the next one, and smoothly into that line.");
    return spec;
}

template <>
const CommandSpec& JoinAt<core::FitJoint::corner_straight>::spec() {
    static const CommandSpec spec = joining<core::FitJoint::corner_straight>(
        "make-fit-point-corner-straight", "Corner, then straight",
        "Leads the curve straight from the selected fit point to the next one, from a corner.");
    return spec;
}

const CommandSpec& SetFitKind::spec() {
    static const CommandSpec spec{
        .name = "set-fit-kind",
        .title = "Set kind of curve through points",
        .explanation = "Makes the curve through its points anew: C², local or fair, open or closed.",
        .synonyms = "parametrization closed centripetal chordal",
        .group = CommandGroup::edit,
        .submenu = "Fit points",
        .effect = ShapeEffect::changes,
        .fields = {field::choice<&SetFitKind::kind>("kind", "how smooth, and how far a change reaches")
                       .beginning_with<present<&core::FitPoints::kind>>(),
                   field::choice<&SetFitKind::parametrization>("parametrization", "how far apart the parameters are")
                       .suggesting<present<&core::FitPoints::parametrization>>(),
                   field::flag<&SetFitKind::closed>("closed", "yes for a curve that returns to the first point")
                       .suggesting<present<&core::FitPoints::closed>>()},
        .refusal = no_fit_points,
        .run = body_of<editor::set_fit_kind>,
        .step = "Set kind of curve through points",
        .done = "Made the curve through its points anew: {kind}, {parametrization}"};
    return spec;
}

const CommandSpec& MakeOrdinary::spec() {
    static const CommandSpec spec{
        .name = "make-ordinary",
        .title = "Turn into ordinary curve",
        .explanation = "Leaves out the points that the curve was made to pass; its control points are edited instead.",
        .synonyms = "fit points convert explode",
        .group = CommandGroup::edit,
        .submenu = "Fit points",
        .effect = ShapeEffect::keeps,
        .refusal = no_fit_points,
        .run = body_of<editor::make_ordinary>,
        .done = "Turned into an ordinary curve"};
    return spec;
}

const CommandSpec& SelectFitPoint::spec() {
    static const CommandSpec spec{
        .name = "select-fit-point",
        .title = "Select fit point",
        .explanation = "Selects a point that the curve passes, or none.",
        .group = CommandGroup::edit,
        .submenu = "Select",
        .fields = {field::count<&SelectFitPoint::index>("index", which_fit_point).absent_as("-1").required()},
        .refusal = no_fit_points,
        .run = body_of<editor::select_fit_point>};
    return spec;
}

void add_fit_point_commands(CommandTable& table) {
    using enum core::FitJoint;
    add_all<MoveFitPoint, InsertFitPoint, DeleteFitPoint, SetFitJoint>(table);
    add_all<JoinAt<smooth>, JoinAt<tangent>, JoinAt<corner>, JoinAt<straight>, JoinAt<corner_straight>>(table);
    add_all<SetFitKind, MakeOrdinary, SelectFitPoint>(table);
}

}  // namespace batten::editor
