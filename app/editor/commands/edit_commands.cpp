#include "app/editor/clipboard.h"
#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"
#include "app/editor/upkeep.h"
#include "core/document/native_file.h"
#include "core/edit/knot_edit.h"
#include "core/edit/point_edit.h"

namespace batten::editor {

namespace {

Outcome<void> undo(EditorState& state, const Arguments&) {
    const core::Document before = state.history.present();
    const std::string label = state.history.undo_label();
    state.history.undo();
    follow_document(state, before);
    state.message = {"Undid: " + label, false};
    return {};
}

Outcome<void> redo(EditorState& state, const Arguments&) {
    const core::Document before = state.history.present();
    const std::string label = state.history.redo_label();
    state.history.redo();
    follow_document(state, before);
    state.message = {"Redid: " + label, false};
    return {};
}

// The active curve alone, as the text of a file.
std::string text_of_active(const EditorState& state) {
    core::Document document;
    document.curves.push_back(*state.history.present().active_curve());
    return core::format_document(document);
}

Outcome<void> copy(EditorState& state, const Arguments&) {
    write_clipboard(state, text_of_active(state));
    state.message = {"Copied curve '" + state.history.present().active_curve()->name + "'", false};
    return {};
}

Outcome<Edit> cut(const EditorState& state, const Arguments&) {
    Outcome<Edit> edit = without_curve(state, state.history.present().active);
    if (edit) edit->clipboard = text_of_active(state);
    return edit;
}

Outcome<Edit> paste(const EditorState& state, const Arguments& arguments) {
    const core::FileResult<core::Document> pasted = core::parse_document(arguments.text(0));
    if (!pasted) return tl::unexpected("the clipboard does not hold curves of Batten: " + pasted.error().sentence());
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

std::optional<Argument> clipboard_text(const EditorState& state) {
    return read_clipboard(state);
}

Outcome<Edit> duplicate(const EditorState& state, const Arguments& arguments) {
    return with_duplicate(state, state.history.present().active, arguments.number(0));
}

std::optional<Refusal> nothing_to_delete(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (!state.selection.points.empty() || state.selection.knot) return std::nullopt;
    return "nothing is selected";
}

Outcome<Edit> delete_selected(const EditorState& state, const Arguments&) {
    const core::Curve& curve = active_curve(state);
    if (!state.selection.points.empty())
        return edit_active(state, core::delete_control_points(curve, state.selection.points), Selection{});
    return edit_active(state, core::delete_knot(curve, *state.selection.knot), Selection{});
}

std::string label_of_delete(const EditorState& state, const Arguments&) {
    const std::vector<std::size_t>& points = state.selection.points;
    if (!points.empty()) return "Delete " + points_text(points);
    return "Delete knot " + number_text(active_curve(state).knots().stored()[*state.selection.knot]);
}

std::string quoted_active_name(const EditorState& state) {
    return "'" + state.history.present().active_curve()->name + "'";
}

constexpr Modifiers ctrl{true, false, false};
constexpr Modifiers ctrl_shift{true, true, false};

void add_history(std::vector<CommandSpec>& table) {
    table.push_back({.name = "undo",
                     .title = "Undo",
                     .explanation = "Takes the last step back.",
                     .group = CommandGroup::edit,
                     .shortcut = {Key::z, ctrl},
                     .refusal = [](const EditorState& state) -> std::optional<Refusal> {
                         if (state.history.can_undo()) return std::nullopt;
                         return "there is nothing to undo";
                     },
                     .act = undo});
    table.push_back({.name = "redo",
                     .title = "Redo",
                     .explanation = "Repeats the step that was taken back last.",
                     .group = CommandGroup::edit,
                     .shortcut = {Key::y, ctrl},
                     .second_shortcut = {Key::z, ctrl_shift},
                     .refusal = [](const EditorState& state) -> std::optional<Refusal> {
                         if (state.history.can_redo()) return std::nullopt;
                         return "there is nothing to redo";
                     },
                     .act = redo});
}

void add_clipboard(std::vector<CommandSpec>& table) {
    table.push_back(
        {.name = "cut",
         .title = "Cut",
         .explanation = "Moves the active curve to the clipboard.",
         .group = CommandGroup::edit,
         .shortcut = {Key::x, ctrl},
         .refusal = no_editable_curve,
         .edit = cut,
         .label = [](const EditorState& state, const Arguments&) { return "Cut curve " + quoted_active_name(state); }});
    table.push_back({.name = "copy",
                     .title = "Copy",
                     .explanation = "Copies the active curve to the clipboard.",
                     .group = CommandGroup::edit,
                     .shortcut = {Key::c, ctrl},
                     .refusal = no_curve,
                     .act = copy});
    table.push_back({.name = "paste",
                     .title = "Paste",
                     .explanation = "Adds the curves of the clipboard to the document.",
                     .group = CommandGroup::edit,
                     .shortcut = {Key::v, ctrl},
                     .parameters = {{"text", ParameterKind::text, "curves as in a file", clipboard_text}},
                     .edit = paste});
    table.push_back({.name = "duplicate",
                     .title = "Duplicate",
                     .explanation = "Adds a copy of the active curve, shifted a little, and makes it active.",
                     .group = CommandGroup::edit,
                     .shortcut = {Key::d, ctrl},
                     .parameters = {{"shift", ParameterKind::number, "how far to the right and down", grid_step}},
                     .refusal = no_curve,
                     .edit = duplicate,
                     .label = [](const EditorState& state, const Arguments&) {
                         return "Duplicate curve " + quoted_active_name(state);
                     }});
    table.push_back({.name = "delete",
                     .title = "Delete",
                     .explanation = "Deletes the selected control points, or else the selected knot.",
                     .group = CommandGroup::edit,
                     .effect = ShapeEffect::changes,
                     .shortcut = {Key::delete_key, {}},
                     .second_shortcut = {Key::backspace, {}},
                     .refusal = nothing_to_delete,
                     .edit = delete_selected,
                     .label = label_of_delete});
}

}  // namespace

void add_edit_commands(std::vector<CommandSpec>& table) {
    add_history(table);
    add_clipboard(table);
}

}  // namespace batten::editor
