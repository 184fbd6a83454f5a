#include "app/editor/commands/file_commands.h"

#include "app/editor/commands/file_acts.h"
#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/show_dialog.h"
#include "app/editor/words/native_name.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

namespace fs = std::filesystem;

Outcome<void> new_document(EditorState& state, const NewDocument& command) {
    return ask_or_proceed(state, command);
}

Outcome<void> open(EditorState& state, const Open& command) {
    if (command.path) return ask_or_proceed(state, command);
    // The question comes once a file is chosen.
    show_dialog(state, Dialog::open_file);
    return {};
}

Outcome<void> open_example(EditorState& state, const OpenExample& command) {
    return ask_or_proceed(state, command);
}

Outcome<Edit> add_file(const EditorState& state, const AddFile& command) {
    return with_curves_of(state, absolute_path(command.path), command.format);
}

Outcome<void> quit(EditorState& state, const Quit& command) {
    return ask_or_proceed(state, command);
}

// What waited for the document to be saved.
Outcome<void> proceed_with_pending(EditorState& state) {
    if (!state.pending) return {};
    const Pending command = *std::exchange(state.pending, std::nullopt);
    return proceed(state, command);
}

Outcome<void> save_to(EditorState& state, const fs::path& path) {
    Outcome<void> saved = save_document_to(state, path);
    if (!saved) {
        // Without a dialog that could be tried again, what waited must not happen at some later saving.
        if (state.dialog == Dialog::none) state.pending.reset();
        return saved;
    }
    state.dialog = Dialog::none;
    return proceed_with_pending(state);
}

// Keeps what is pending, unlike other dialogs.
Outcome<void> ask_for_path(EditorState& state) {
    state.dialog = Dialog::save_file;
    return {};
}

// Whether the file is not what was read or written last. Asks what to do then, and keeps what is pending. Where even
// its folder is gone, there is nothing to choose.
bool asks_about_change(EditorState& state) {
    std::error_code error;
    const bool is_the_same = !state.stamp || state.stamp == core::file_stamp(state.path);
    if (is_the_same || !fs::exists(state.path.parent_path(), error)) return false;
    state.dialog = Dialog::changed_file;
    return true;
}

Outcome<void> save(EditorState& state, const Save&) {
    if (state.path.empty()) return ask_for_path(state);
    if (asks_about_change(state)) return {};
    return save_to(state, state.path);
}

bool is_own_file(const EditorState& state, const fs::path& path) {
    std::error_code error;
    return !state.path.empty() && (path == state.path || fs::equivalent(path, state.path, error));
}

// A copy or a figure is not what an answer about unsaved changes waits for.
Outcome<void> export_to(EditorState& state, const SavedName& name) {
    const fs::path path = absolute_path(name.path);
    if (is_own_file(state, path))
        return tl::unexpected(
            core::sentence("{file} is the document itself; a copy for another program needs another name",
                           {{"file", path.filename().string()}}));
    Outcome<void> exported =
        name.is_figure ? export_figure_to(state, path) : export_document_to(state, path, *name.format);
    if (exported) show_dialog(state, Dialog::none);
    return exported;
}

Outcome<void> save_as(EditorState& state, const SaveAs& command) {
    if (!command.path) return ask_for_path(state);
    return saved_name(*command.path, command.format).and_then([&](const SavedName& name) {
        if (name.format || name.is_figure) return export_to(state, name);
        const fs::path path = absolute_path(name.path);
        return is_own_file(state, path) ? save(state, {}) : save_to(state, path);
    });
}

Outcome<void> answer_unsaved(EditorState& state, const AnswerUnsaved& command) {
    state.dialog = Dialog::none;
    switch (command.answer) {
        case UnsavedAnswer::discard:
            return proceed_with_pending(state);
        case UnsavedAnswer::save:
            return save(state, Save{});
        case UnsavedAnswer::cancel:
            break;
    }
    state.pending.reset();
    return {};
}

Outcome<void> answer_changed(EditorState& state, const AnswerChanged& command) {
    state.dialog = Dialog::none;
    switch (command.answer) {
        case ChangedAnswer::overwrite:
            return save_to(state, state.path);
        case ChangedAnswer::save_as:
            return ask_for_path(state);
        case ChangedAnswer::cancel:
            break;
    }
    state.pending.reset();
    return {};
}

std::optional<Refusal> no_changed_file(const EditorState& state) {
    if (state.dialog == Dialog::changed_file) return std::nullopt;
    return "no question about a changed file is open";
}

std::optional<Refusal> no_question(const EditorState& state) {
    if (state.dialog == Dialog::unsaved_changes) return std::nullopt;
    return "no question about unsaved changes is open";
}

template <class C>
Field format_field() {
    return field::choice<&C::format>("format", "what kind of file it is; left out: by its ending")
        .absent_as("")
        .unasked();
}

}  // namespace

const CommandSpec& NewDocument::spec() {
    static const CommandSpec spec{.name = "new",
                                  .title = "New",
                                  .explanation = "Starts an empty document.",
                                  .group = CommandGroup::file,
                                  .offered = in_the_window,
                                  .shortcut = {Key::n, with_ctrl},
                                  .run = body_of<new_document>};
    return spec;
}

const CommandSpec& Open::spec() {
    static const CommandSpec spec{
        .name = "open",
        .title = "Open…",
        .explanation = "Opens a file of Batten, or of another program.",
        .synonyms = "load import svg dxf step iges",
        .group = CommandGroup::file,
        .offered = in_the_window,
        .shortcut = {Key::o, with_ctrl},
        .fields = {field::file<&Open::path>("path", "the file; left out: asks for one").absent_as("").unasked(),
                   format_field<Open>()},
        .run = body_of<open>,
        .at_work = "Opening {path}"};
    return spec;
}

const CommandSpec& AddFile::spec() {
    static const CommandSpec spec{.name = "add-file",
                                  .title = "Add file",
                                  .explanation = "Adds the curves of a file to the document.",
                                  .synonyms = "import load",
                                  .group = CommandGroup::file,
                                  .offered = in_the_window,
                                  .fields = {field::file<&AddFile::path>("path", "the file"), format_field<AddFile>()},
                                  .run = body_of<add_file>,
                                  .at_work = "Adding {path}",
                                  .step = "Add file {path}",
                                  .done = "Added file {path}"};
    return spec;
}

const CommandSpec& OpenExample::spec() {
    static const CommandSpec spec{
        .name = "open-example",
        .title = "Open example",
        .explanation = "Opens one of the examples as an untitled document.",
        .synonyms = "sample",
        .group = CommandGroup::file,
        .offered = in_the_window,
        .fields = {field::text<&OpenExample::name>("name", "the name of the example's file, without its ending")},
        .run = body_of<open_example>};
    return spec;
}

const CommandSpec& Save::spec() {
    static const CommandSpec spec{.name = "save",
                                  .title = "Save",
                                  .explanation = "Saves the document to its file.",
                                  .synonyms = "write",
                                  .group = CommandGroup::file,
                                  .offered = in_the_window,
                                  .shortcut = {Key::s, with_ctrl},
                                  .run = body_of<save>,
                                  .at_work = "Saving the document"};
    return spec;
}

const CommandSpec& SaveAs::spec() {
    static const CommandSpec spec{
        .name = "save-as",
        .title = "Save as…",
        .explanation = "Saves the document to another file, or a copy of its curves for another program.",
        .synonyms = "write export svg dxf step iges",
        .group = CommandGroup::file,
        .offered = in_the_window,
        .shortcut = {Key::s, with_ctrl_shift},
        .fields = {field::file<&SaveAs::path>("path", "the file; left out: asks for one").absent_as("").unasked(),
                   format_field<SaveAs>()},
        .run = body_of<save_as>,
        .at_work = "Saving {path}"};
    return spec;
}

const CommandSpec& AnswerUnsaved::spec() {
    static const CommandSpec spec{
        .name = "answer-unsaved",
        .title = "Answer about unsaved changes",
        .explanation = "Saves or discards unsaved changes before going on, or cancels.",
        .group = CommandGroup::gesture,
        .offered = nowhere,
        .fields = {field::choice<&AnswerUnsaved::answer>("answer", "what becomes of the changes")},
        .refusal = no_question,
        .run = body_of<answer_unsaved>,
        .at_work = "Going on"};
    return spec;
}

const CommandSpec& AnswerChanged::spec() {
    static const CommandSpec spec{
        .name = "answer-changed",
        .title = "Answer about a changed file",
        .explanation = "Overwrites a file that another program changed, saves another one, or cancels.",
        .group = CommandGroup::gesture,
        .offered = nowhere,
        .fields = {field::choice<&AnswerChanged::answer>("answer", "what becomes of the changed file")},
        .refusal = no_changed_file,
        .run = body_of<answer_changed>,
        .at_work = "Saving the document"};
    return spec;
}

const CommandSpec& Quit::spec() {
    static const CommandSpec spec{.name = "quit",
                                  .title = "Quit",
                                  .explanation = "Leaves Batten; asks about unsaved changes.",
                                  .synonyms = "exit close",
                                  .group = CommandGroup::file,
                                  .offered = in_the_window,
                                  .shortcut = {Key::q, with_ctrl},
                                  .run = body_of<quit>};
    return spec;
}

void add_file_commands(CommandTable& table) {
    add_all<NewDocument, Open, AddFile, OpenExample, Save, SaveAs, AnswerUnsaved, AnswerChanged, Quit>(table);
}

}  // namespace batten::editor
