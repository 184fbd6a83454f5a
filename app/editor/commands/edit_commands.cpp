#include "app/editor/commands/edit_commands.h"

#include "app/editor/clipboard.h"
#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/finding_rows.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/field_kinds.h"
#include "app/editor/formula.h"
#include "app/editor/upkeep.h"
#include "core/base/sentence.h"
#include "core/document/native_file.h"
#include "core/edit/knot_edit.h"
#include "core/edit/point_edit.h"

namespace batten::editor {

namespace {

using core::sentence;

Outcome<void> undo(EditorState& state, const Undo&) {
    const core::Document before = state.history.present();
    const std::string label = state.history.undo_label();
    state.history.undo();
    follow_document(state, before);
    state.message = {sentence("Undid: {step}", {{"step", label}}), false};
    return {};
}

Outcome<void> redo(EditorState& state, const Redo&) {
    const core::Document before = state.history.present();
    const std::string label = state.history.redo_label();
    state.history.redo();
    follow_document(state, before);
    state.message = {sentence("Redid: {step}", {{"step", label}}), false};
    return {};
}

std::optional<Refusal> nothing_to_undo(const EditorState& state) {
    if (state.history.can_undo()) return std::nullopt;
    return "there is nothing to undo";
}

std::optional<Refusal> nothing_to_redo(const EditorState& state) {
    if (state.history.can_redo()) return std::nullopt;
    return "there is nothing to redo";
}

// The active curve alone, as the text of a file.
std::string text_of_active(const EditorState& state) {
    core::Document document;
    document.curves.push_back(*state.history.present().active_curve());
    return core::format_document(document);
}

Outcome<void> copy(EditorState& state, const Copy&) {
    write_clipboard(state, text_of_active(state));
    state.message = {sentence("Copied curve '{name}'", {active_name(state)}), false};
    return {};
}

Outcome<Edit> cut(const EditorState& state, const Cut&) {
    Outcome<Edit> edit = without_curve(state, state.history.present().active);
    if (edit) edit->clipboard = text_of_active(state);
    return edit;
}

StepTexts texts_of_cut(const EditorState& state, const Cut&) {
    return {sentence("Cut curve '{name}'", {active_name(state)}), sentence("Cut curve '{name}'", {active_name(state)})};
}

Outcome<Edit> paste(const EditorState& state, const Paste& command) {
    const core::FileResult<core::Document> pasted = core::parse_document(command.text);
    if (!pasted)
        return tl::unexpected(
            sentence("the clipboard holds no Batten curves: {reason}", {{"reason", pasted.error().sentence()}}));
    if (pasted->curves.empty()) return tl::unexpected(Refusal("the clipboard holds a document without curves"));
    Edit edit{state.history.present(), Selection{}};
    for (core::DocumentCurve curve : pasted->curves) {
        curve.name = core::unused_name(edit.document, curve.name);
        curve.visible = true;
        curve.locked = false;
        edit.document.curves.push_back(std::move(curve));
    }
    edit.document.active = edit.document.curves.size() - 1;
    return edit;
}

std::string clipboard_text(const EditorState& state) {
    return read_clipboard(state);
}

Outcome<Edit> duplicate(const EditorState& state, const Duplicate& command) {
    return with_duplicate(state, state.history.present().active, command.shift);
}

StepTexts texts_of_duplicate(const EditorState& state, const Duplicate&) {
    return {sentence("Duplicate curve '{name}'", {active_name(state)}),
            sentence("Duplicated curve '{name}'", {active_name(state)})};
}

std::optional<Refusal> nothing_to_delete(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (!state.selection.points.empty() || state.selection.knot) return std::nullopt;
    return "nothing is selected";
}

Outcome<Edit> delete_selected(const EditorState& state, const Delete&) {
    const core::Curve& curve = active_curve(state);
    if (!state.selection.points.empty())
        return edit_active(state, core::delete_control_points(curve, state.selection.points), Selection{});
    return edit_active(state, core::delete_knot(curve, *state.selection.knot), Selection{});
}

StepTexts texts_of_delete(const EditorState& state, const Delete&) {
    if (!state.selection.points.empty()) {
        const core::Place points("points", points_text(state.selection.points));
        return {sentence("Delete {points}", {points}), sentence("Deleted {points}", {points})};
    }
    const core::Place knot("knot", number_text(active_curve(state).knots().stored()[*state.selection.knot]));
    return {sentence("Delete knot {knot}", {knot}), sentence("Deleted knot {knot}", {knot})};
}

}  // namespace

const CommandSpec& Undo::spec() {
    static const CommandSpec spec{.name = "undo",
                                  .title = "Undo",
                                  .explanation = "Takes back the last step.",
                                  .group = CommandGroup::edit,
                                  .offered = in_the_window,
                                  .shortcut = {Key::z, with_ctrl},
                                  .refusal = nothing_to_undo,
                                  .run = body_of<undo>};
    return spec;
}

const CommandSpec& Redo::spec() {
    static const CommandSpec spec{.name = "redo",
                                  .title = "Redo",
                                  .explanation = "Repeats the step that was last taken back.",
                                  .group = CommandGroup::edit,
                                  .offered = in_the_window,
                                  .shortcut = {Key::y, with_ctrl},
                                  .second_shortcut = {Key::z, with_ctrl_shift},
                                  .refusal = nothing_to_redo,
                                  .run = body_of<redo>};
    return spec;
}

const CommandSpec& Cut::spec() {
    static const CommandSpec spec{.name = "cut",
                                  .title = "Cut",
                                  .explanation = "Moves the active curve to the clipboard.",
                                  .group = CommandGroup::edit,
                                  .shortcut = {Key::x, with_ctrl},
                                  .refusal = no_editable_curve,
                                  .run = body_of<cut>,
                                  .texts = texts_of<texts_of_cut>};
    return spec;
}

const CommandSpec& Copy::spec() {
    static const CommandSpec spec{.name = "copy",
                                  .title = "Copy",
                                  .explanation = "Copies the active curve to the clipboard.",
                                  .group = CommandGroup::edit,
                                  .offered = in_the_window,
                                  .shortcut = {Key::c, with_ctrl},
                                  .refusal = no_curve,
                                  .run = body_of<copy>};
    return spec;
}

const CommandSpec& Paste::spec() {
    static const CommandSpec spec{
        .name = "paste",
        .title = "Paste",
        .explanation = "Adds the curves of the clipboard to the document.",
        .group = CommandGroup::edit,
        .shortcut = {Key::v, with_ctrl},
        .fields = {field::text<&Paste::text>("text", "curves as in a file").suggesting<clipboard_text>().unasked()},
        .run = body_of<paste>,
        .done = "Pasted"};
    return spec;
}

const CommandSpec& Duplicate::spec() {
    static const CommandSpec spec{
        .name = "duplicate",
        .title = "Duplicate",
        .explanation = "Adds a copy of the active curve, shifted a little, and makes it active.",
        .synonyms = "copy",
        .group = CommandGroup::edit,
        .shortcut = {Key::d, with_ctrl},
        .fields = {field::length<&Duplicate::shift>("shift", "how far to the right and down")
                       .suggesting<suggest::grid_step>()
                       .unasked()},
        .refusal = no_curve,
        .run = body_of<duplicate>,
        .texts = texts_of<texts_of_duplicate>};
    return spec;
}

const CommandSpec& Delete::spec() {
    static const CommandSpec spec{.name = "delete",
                                  .title = "Delete",
                                  .explanation = "Deletes the selected control points, or else the selected knot.",
                                  .synonyms = "remove",
                                  .group = CommandGroup::edit,
                                  .effect = ShapeEffect::changes,
                                  .shortcut = {Key::delete_key, {}},
                                  .second_shortcut = {Key::backspace, {}},
                                  .refusal = nothing_to_delete,
                                  .run = body_of<delete_selected>,
                                  .texts = texts_of<texts_of_delete>};
    return spec;
}

void add_edit_commands(CommandTable& table) {
    add_all<Undo, Redo, Cut, Copy, Paste, Duplicate, Delete>(table);
}

}  // namespace batten::editor
