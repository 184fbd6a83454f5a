#include "app/editor/commands/document_commands.h"

#include <algorithm>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/refusal.h"
#include "core/base/sentence.h"
#include "core/curve/knot_kinds.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr const char* which_curve = "which curve, counted from 0";

Outcome<Edit> new_curve(const EditorState& state, const NewCurve& command) {
    core::Result<core::Curve> curve = curve_of_control_points(command.points, command.degree, command.closed);
    if (!curve) return refused(state, curve.error());
    return with_curve(state, "curve", *std::move(curve));
}

Outcome<Edit> delete_curve(const EditorState& state, const DeleteCurve& command) {
    return without_curve(state, command.index);
}

Outcome<Edit> duplicate_curve(const EditorState& state, const DuplicateCurve& command) {
    return with_duplicate(state, command.index, command.shift);
}

// An edit of one entry of the document that leaves its curve alone.
template <class Change>
Edit change_entry(const EditorState& state, std::size_t index, Change change) {
    Edit edit{state.history.present()};
    change(edit.document.curves[index]);
    return edit;
}

Outcome<Edit> rename_curve(const EditorState& state, const RenameCurve& command) {
    if (command.name.empty()) return tl::unexpected(Refusal("a curve needs a name; the one given is empty"));
    const std::vector<core::DocumentCurve>& curves = state.history.present().curves;
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (curves[i].name == command.name && i != command.index)
            return tl::unexpected(sentence("curve {index} is called '{name}' already; names must differ",
                                           {{"index", i}, {"name", command.name}}));
    return change_entry(state, command.index, [&](core::DocumentCurve& curve) { curve.name = command.name; });
}

Outcome<Edit> set_color(const EditorState& state, const SetCurveColor& command) {
    return change_entry(state, command.index, [&](core::DocumentCurve& curve) { curve.color = command.color; });
}

Outcome<Edit> set_visible(const EditorState& state, const SetCurveVisible& command) {
    return change_entry(state, command.index, [&](core::DocumentCurve& curve) { curve.visible = command.visible; });
}

Outcome<Edit> set_locked(const EditorState& state, const SetCurveLocked& command) {
    return change_entry(state, command.index, [&](core::DocumentCurve& curve) { curve.locked = command.locked; });
}

StepTexts texts_of_visibility(const EditorState& state, const SetCurveVisible& command) {
    const core::Place name("name", state.history.present().curves[command.index].name);
    if (command.visible) return {sentence("Show curve '{name}'", {name}), sentence("Showed curve '{name}'", {name})};
    return {sentence("Hide curve '{name}'", {name}), sentence("Hid curve '{name}'", {name})};
}

StepTexts texts_of_lock(const EditorState& state, const SetCurveLocked& command) {
    const core::Place name("name", state.history.present().curves[command.index].name);
    if (command.locked) return {sentence("Lock curve '{name}'", {name}), sentence("Locked curve '{name}'", {name})};
    return {sentence("Unlock curve '{name}'", {name}), sentence("Unlocked curve '{name}'", {name})};
}

template <auto member>
Field index_field() {
    return field::curve_index<member>("i", which_curve);
}

}  // namespace

core::Result<core::Curve> curve_of_control_points(std::vector<core::Point> points, int degree, bool closed) {
    const core::KnotKind kind = closed ? core::KnotKind::periodic : core::KnotKind::clamped_uniform;
    const int possible = closed ? degree : std::min(degree, static_cast<int>(points.size()) - 1);
    return core::make_knots(kind, possible, points.size()).and_then([&](core::KnotVector knots) {
        return core::Curve::make(std::move(knots), std::move(points), {});
    });
}

const CommandSpec& NewCurve::spec() {
    static const CommandSpec spec{
        .name = "new-curve",
        .title = "New curve",
        .explanation = "Adds a uniform curve, clamped at its first and last point or closed, and makes it active.",
        .synonyms = "draw B-spline",
        .group = CommandGroup::make,
        .fields = {field::positions<&NewCurve::points>("coordinates", "x and y of each control point").at_least(2.0),
                   field::count<&NewCurve::degree>("degree", "lowered where there are too few points").usually(3),
                   field::flag<&NewCurve::closed>("closed", "yes for a periodic curve").usually(false)},
        .run = body_of<new_curve>,
        .step = "Draw curve",
        .done = "Drew curve"};
    return spec;
}

const CommandSpec& DeleteCurve::spec() {
    static const CommandSpec spec{.name = "delete-curve",
                                  .title = "Delete curve",
                                  .explanation = "Removes a curve from the document.",
                                  .synonyms = "remove",
                                  .group = CommandGroup::curve,
                                  .fields = {index_field<&DeleteCurve::index>().suggesting<suggest::active_curve>()},
                                  .refusal = no_curve,
                                  .run = body_of<delete_curve>,
                                  .step = "Delete curve {i}",
                                  .done = "Deleted curve {i}"};
    return spec;
}

const CommandSpec& DuplicateCurve::spec() {
    static const CommandSpec spec{
        .name = "duplicate-curve",
        .title = "Duplicate curve",
        .explanation = "Adds a copy of a curve, shifted a little, and makes it active.",
        .synonyms = "copy",
        .group = CommandGroup::curve,
        .fields = {index_field<&DuplicateCurve::index>().suggesting<suggest::active_curve>(),
                   field::length<&DuplicateCurve::shift>("shift", "how far to the right and down")
                       .suggesting<suggest::grid_step>()},
        .refusal = no_curve,
        .run = body_of<duplicate_curve>,
        .step = "Duplicate curve {i}",
        .done = "Duplicated curve {i}"};
    return spec;
}

const CommandSpec& RenameCurve::spec() {
    static const CommandSpec spec{.name = "rename-curve",
                                  .title = "Rename curve",
                                  .explanation = "Gives a curve another name.",
                                  .group = CommandGroup::curve,
                                  .fields = {index_field<&RenameCurve::index>().beginning_with<suggest::active_curve>(),
                                             field::text<&RenameCurve::name>("name", "its new name")},
                                  .refusal = no_curve,
                                  .run = body_of<rename_curve>,
                                  .step = "Rename curve {i}",
                                  .done = "Renamed curve {i}"};
    return spec;
}

const CommandSpec& SetCurveColor::spec() {
    static const CommandSpec spec{
        .name = "set-curve-color",
        .title = "Set color of curve",
        .explanation = "Gives a curve a color of its own, or the default one.",
        .group = CommandGroup::curve,
        .fields = {index_field<&SetCurveColor::index>().beginning_with<suggest::active_curve>(),
                   field::color<&SetCurveColor::color>("color", "of the form #4c7fe0, or none").required()},
        .refusal = no_curve,
        .run = body_of<set_color>,
        .step = "Set color of {i}",
        .done = "Set color of {i}"};
    return spec;
}

const CommandSpec& SetCurveVisible::spec() {
    static const CommandSpec spec{
        .name = "set-curve-visible",
        .title = "Show or hide curve",
        .explanation = "Shows a curve, or hides it.",
        .group = CommandGroup::curve,
        .fields = {index_field<&SetCurveVisible::index>().beginning_with<suggest::active_curve>(),
                   field::flag<&SetCurveVisible::visible>("visible", "yes to show it, no to hide it")},
        .refusal = no_curve,
        .run = body_of<set_visible>,
        .texts = texts_of<texts_of_visibility>};
    return spec;
}

const CommandSpec& SetCurveLocked::spec() {
    static const CommandSpec spec{
        .name = "set-curve-locked",
        .title = "Lock or unlock curve",
        .explanation = "Protects a curve from changes of its shape, or allows them again.",
        .synonyms = "protect",
        .group = CommandGroup::curve,
        .fields = {index_field<&SetCurveLocked::index>().beginning_with<suggest::active_curve>(),
                   field::flag<&SetCurveLocked::locked>("locked", "yes to lock it, no to unlock it")},
        .refusal = no_curve,
        .run = body_of<set_locked>,
        .texts = texts_of<texts_of_lock>};
    return spec;
}

void add_document_commands(CommandTable& table) {
    add_all<NewCurve, DeleteCurve, DuplicateCurve>(table);
    add_all<RenameCurve, SetCurveColor, SetCurveVisible, SetCurveLocked>(table);
}

}  // namespace batten::editor
