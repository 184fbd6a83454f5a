#include "app/editor/commands/edit_commands.h"

#include <algorithm>

#include "app/editor/clipboard.h"
#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/added_curves.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/finding_rows.h"
#include "app/editor/commands/fit_point_commands.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/map_selected.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/symmetry_links.h"
#include "app/editor/upkeep.h"
#include "app/editor/words/refusal.h"
#include "app/editor/words/wording.h"
#include "core/base/sentence.h"
#include "core/document/native_file.h"
#include "core/document/point_table.h"
#include "core/edit/knot_edit.h"

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

bool cannot_undo(const EditorState& state) {
    return !state.history.can_undo();
}

bool cannot_redo(const EditorState& state) {
    return !state.history.can_redo();
}

std::string aim_of_undo(const EditorState& state) {
    return sentence("Takes back: {step}", {{"step", state.history.undo_label()}});
}

std::string aim_of_redo(const EditorState& state) {
    return sentence("Repeats: {step}", {{"step", state.history.redo_label()}});
}

std::optional<Refusal> nothing_to_undo(const EditorState& state) {
    if (state.history.can_undo()) return std::nullopt;
    return "there is nothing to undo";
}

std::optional<Refusal> nothing_to_redo(const EditorState& state) {
    if (state.history.can_redo()) return std::nullopt;
    return "there is nothing to redo";
}

SelectedParts parts_meant(const EditorState& state) {
    SelectedParts parts;
    for (const std::size_t i : curves_meant(state)) parts.push_back({i});
    return parts;
}

bool is_one_meant(const EditorState& state) {
    return !state.selection.is_over_curves();
}

// As the text of a file.
std::string text_of_meant(const EditorState& state) {
    core::Document document;
    document.units = units_of(state);
    for (const std::size_t i : curves_meant(state)) document.curves.push_back(state.history.present().curves[i]);
    return core::format_document(document);
}

Outcome<void> copy(EditorState& state, const Copy&) {
    write_clipboard(state, text_of_meant(state));
    state.message = {is_one_meant(state) ? sentence("Copied curve '{name}'", {active_name(state)})
                                         : sentence("Copied {curves}", {names_of_meant(state)}),
                     false};
    return {};
}

Outcome<void> copy_text(EditorState& state, const CopyText& command) {
    write_clipboard(state, command.text);
    state.message = {"Copied the text", false};
    return {};
}

Outcome<Edit> cut(const EditorState& state, const Cut&) {
    Outcome<Edit> edit = without_parts(state, parts_meant(state));
    if (edit) edit->clipboard = text_of_meant(state);
    return edit;
}

std::optional<Refusal> nothing_to_cut(const EditorState& state) {
    return is_one_meant(state) ? no_editable_curve(state) : nothing_to_map(state);
}

StepTexts texts_of_cut(const EditorState& state, const Cut&) {
    if (!is_one_meant(state))
        return {sentence("Cut {curves}", {names_of_meant(state)}), sentence("Cut {curves}", {names_of_meant(state)})};
    return {sentence("Cut curve '{name}'", {active_name(state)}), sentence("Cut curve '{name}'", {active_name(state)})};
}

/// Curves that were copied, in the units of the document, and what is to be said of them.
struct CopiedCurves {
    core::Document document;
    std::optional<std::string> remark{};
};

Outcome<CopiedCurves> copied_curves(const EditorState& state, const std::string& text) {
    core::FileResult<core::Document> pasted = core::parse_document(text);
    if (!pasted && core::read_point_table(text))
        return tl::unexpected(
            Refusal("the clipboard holds a table of points; Edit > Paste points… makes a curve of it"));
    if (!pasted)
        return tl::unexpected(
            sentence("the clipboard holds no Batten curves: {reason}", {{"reason", pasted.error().sentence()}}));
    if (pasted->curves.empty()) return tl::unexpected(Refusal("the clipboard holds a document without curves"));
    return convert_units(*pasted, units_of(state)).map([&](std::optional<std::string> remark) {
        return CopiedCurves{*std::move(pasted), std::move(remark)};
    });
}

Outcome<Edit> with_curves_of_text(const EditorState& state, const std::string& text, double shift) {
    Outcome<CopiedCurves> copied = copied_curves(state, text);
    if (!copied) return tl::unexpected(copied.error());
    for (core::DocumentCurve& curve : copied->document.curves) {
        if (const auto shifted = shift_entry(curve, shift); !shifted) return refused(state, shifted.error());
        if (curve.symmetry) curve.symmetry = mapped_symmetry(*curve.symmetry, core::translation({shift, -shift}));
        curve.visible = true;
        curve.locked = false;
    }
    Edit edit{state.history.present(), Selection{}};
    add_curves(edit.document, std::move(copied->document.curves));
    edit.document.active = edit.document.curves.size() - 1;
    edit.remark = std::move(copied->remark);
    return edit;
}

Outcome<Edit> paste(const EditorState& state, const Paste& command) {
    return with_curves_of_text(state, command.text, 0.0);
}

Outcome<Edit> paste_beside(const EditorState& state, const PasteBeside& command) {
    return with_curves_of_text(state, command.text, command.shift);
}

bool has_curve(const core::Document& document, const core::Curve& curve) {
    return std::any_of(document.curves.begin(), document.curves.end(),
                       [&curve](const core::DocumentCurve& item) { return *item.curve == curve; });
}

// Whether a curve of `pasted`, moved by `shift`, would cover one of the document exactly.
bool would_cover(const EditorState& state, const core::Document& pasted, double shift) {
    return std::any_of(pasted.curves.begin(), pasted.curves.end(), [&](core::DocumentCurve item) {
        return shift_entry(item, shift) && has_curve(state.history.present(), *item.curve);
    });
}

// The first of 0, 1, 2, ... steps of the grid at which nothing is covered; every curve of the document can stop
// one of them for each that is pasted.
double free_shift(const EditorState& state) {
    const Outcome<CopiedCurves> copied = copied_curves(state, read_clipboard(state));
    if (!copied) return 0.0;
    const double step = suggest::grid_step(state);
    const std::size_t most = state.history.present().curves.size() * copied->document.curves.size();
    std::size_t steps = 0;
    while (steps < most && would_cover(state, copied->document, static_cast<double>(steps) * step)) ++steps;
    return static_cast<double>(steps) * step;
}

std::string clipboard_text(const EditorState& state) {
    return read_clipboard(state);
}

Outcome<Edit> duplicate(const EditorState& state, const Duplicate& command) {
    if (is_one_meant(state)) return with_duplicate(state, state.history.present().active, command.shift);
    return with_duplicates(state, curves_meant(state), command.shift);
}

StepTexts texts_of_duplicate(const EditorState& state, const Duplicate&) {
    if (!is_one_meant(state))
        return {sentence("Duplicate {curves}", {names_of_meant(state)}),
                sentence("Duplicated {curves}", {names_of_meant(state)})};
    return {sentence("Duplicate curve '{name}'", {active_name(state)}),
            sentence("Duplicated curve '{name}'", {active_name(state)})};
}

bool has_nothing_selected(const EditorState& state) {
    return !no_curve_at_hand(state) && state.selection.is_empty();
}

std::optional<Refusal> nothing_to_delete(const EditorState& state) {
    if (state.selection.is_over_curves()) return nothing_to_map(state);
    if (std::optional<Refusal> refusal = no_curve_at_hand(state)) return refusal;
    if (!state.selection.is_empty()) return std::nullopt;
    return "nothing is selected";
}

Outcome<Edit> delete_selected(const EditorState& state, const Delete&) {
    if (state.selection.is_over_curves()) return without_parts(state, selected_parts(state));
    if (state.selection.fit_point) return without_fit_point(state, *state.selection.fit_point);
    if (!state.selection.points.empty()) return without_points(state, state.selection.points);
    return edit_active(state, core::delete_knot(active_curve(state), *state.selection.knot), Selection{});
}

StepTexts texts_of_delete(const EditorState& state, const Delete&) {
    if (state.selection.is_over_curves()) {
        const core::Place what("what", selected_words(state));
        return {sentence("Delete {what}", {what}), sentence("Deleted {what}", {what})};
    }
    if (state.selection.fit_point) return texts_of_deleted_fit_point(*state.selection.fit_point);
    if (!state.selection.points.empty()) return texts_of_deleting(state, state.selection.points);
    const core::Curve& curve = active_curve(state);
    return texts_of_deleted_knot(curve, *state.selection.knot, *core::delete_knot(curve, *state.selection.knot));
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
                                  .is_idle = cannot_undo,
                                  .aim = aim_of_undo,
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
                                  .is_idle = cannot_redo,
                                  .aim = aim_of_redo,
                                  .run = body_of<redo>};
    return spec;
}

const CommandSpec& Cut::spec() {
    static const CommandSpec spec{.name = "cut",
                                  .title = "Cut",
                                  .explanation = "Moves the active curve, or all that are selected, to the clipboard.",
                                  .group = CommandGroup::edit,
                                  .shortcut = {Key::x, with_ctrl},
                                  .refusal = nothing_to_cut,
                                  .run = body_of<cut>,
                                  .texts = texts_of<texts_of_cut>};
    return spec;
}

const CommandSpec& Copy::spec() {
    static const CommandSpec spec{.name = "copy",
                                  .title = "Copy",
                                  .explanation = "Copies the active curve, or all that are selected, to the clipboard.",
                                  .group = CommandGroup::edit,
                                  .offered = in_the_window,
                                  .shortcut = {Key::c, with_ctrl},
                                  .refusal = no_curve,
                                  .run = body_of<copy>};
    return spec;
}

const CommandSpec& CopyText::spec() {
    static const CommandSpec spec{.name = "copy-text",
                                  .title = "Copy text",
                                  .explanation = "Copies a text of the window to the clipboard.",
                                  .group = CommandGroup::gesture,
                                  .offered = nowhere,
                                  .fields = {field::text<&CopyText::text>("text", "what to copy")},
                                  .run = body_of<copy_text>,
                                  .is_logged = false};
    return spec;
}

const CommandSpec& Paste::spec() {
    static const CommandSpec spec{
        .name = "paste",
        .title = "Paste in place",
        .explanation = "Adds the curves of the clipboard to the document, exactly where they were copied.",
        .group = CommandGroup::edit,
        .shortcut = {Key::v, with_ctrl_shift},
        .fields = {field::text<&Paste::text>("text", "curves as in a file").suggesting<clipboard_text>().unasked()},
        .run = body_of<paste>,
        .done = "Pasted"};
    return spec;
}

const CommandSpec& PasteBeside::spec() {
    static const CommandSpec spec{
        .name = "paste-beside",
        .title = "Paste",
        .explanation = "Adds the curves of the clipboard to the document, beside what they would cover.",
        .group = CommandGroup::edit,
        .shortcut = {Key::v, with_ctrl},
        .fields =
            {field::text<&PasteBeside::text>("text", "curves as in a file").suggesting<clipboard_text>().unasked(),
             field::length<&PasteBeside::shift>("shift", "how far to the right and down")
                 .suggesting<free_shift>()
                 .unasked()},
        .run = body_of<paste_beside>,
        .step = "Paste",
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
    static const CommandSpec spec{
        .name = "delete",
        .title = "Delete",
        .explanation =
            "Deletes the selected curves and control points, or else the selected knot; the curve where all its points "
            "are selected.",
        .synonyms = "remove",
        .group = CommandGroup::edit,
        .effect = ShapeEffect::changes,
        .shortcut = {Key::delete_key, {}},
        .second_shortcut = {Key::backspace, {}},
        .refusal = nothing_to_delete,
        .is_idle = has_nothing_selected,
        .run = body_of<delete_selected>,
        .texts = texts_of<texts_of_delete>};
    return spec;
}

void add_edit_commands(CommandTable& table) {
    add_all<Undo, Redo, Cut, Copy, CopyText, PasteBeside, Paste, Duplicate, Delete>(table);
}

}  // namespace batten::editor
