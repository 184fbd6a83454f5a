#include "app/editor/commands/file_acts.h"
#include "app/editor/commands/groups.h"
#include "app/editor/dialog.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;
namespace fs = std::filesystem;

// Asks about unsaved changes first; the command then waits for the answer.
Outcome<void> ask_or_proceed(EditorState& state, Command command) {
    if (!state.is_modified()) return proceed(state, command);
    show_dialog(state, Dialog::unsaved_changes);
    state.pending = std::move(command);
    return {};
}

Outcome<void> new_document(EditorState& state, const Arguments&) {
    return ask_or_proceed(state, {"new", {}});
}

Outcome<void> open(EditorState& state, const Arguments& arguments) {
    if (!arguments.text(0).empty()) return ask_or_proceed(state, {"open", arguments.values()});
    // The question comes once a file is chosen.
    show_dialog(state, Dialog::open_file);
    return {};
}

Outcome<void> open_example(EditorState& state, const Arguments& arguments) {
    return ask_or_proceed(state, {"open-example", arguments.values()});
}

Outcome<Edit> add_file(const EditorState& state, const Arguments& arguments) {
    return with_curves_of(state, fs::absolute(arguments.text(0)));
}

Outcome<void> quit(EditorState& state, const Arguments&) {
    return ask_or_proceed(state, {"quit", {}});
}

// What waited for the document to be saved.
Outcome<void> proceed_with_pending(EditorState& state) {
    if (!state.pending) return {};
    const Command command = *std::exchange(state.pending, std::nullopt);
    return proceed(state, command);
}

Outcome<void> save_to(EditorState& state, const fs::path& path) {
    const Outcome<void> saved = save_document_to(state, path);
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

Outcome<void> save(EditorState& state, const Arguments&) {
    return state.path.empty() ? ask_for_path(state) : save_to(state, state.path);
}

Outcome<void> save_as(EditorState& state, const Arguments& arguments) {
    if (arguments.text(0).empty()) return ask_for_path(state);
    fs::path path = fs::absolute(arguments.text(0));
    if (!path.has_extension()) path += ".json";
    return save_to(state, path);
}

Outcome<void> answer_unsaved(EditorState& state, const Arguments& arguments) {
    const std::string& answer = arguments.text(0);
    if (answer != "save" && answer != "discard" && answer != "cancel")
        return tl::unexpected("the answer is '" + answer + "'; it must be save, discard or cancel");
    state.dialog = Dialog::none;
    if (answer == "discard") return proceed_with_pending(state);
    if (answer == "save") return save(state, arguments);
    state.pending.reset();
    return {};
}

std::optional<Refusal> no_question(const EditorState& state) {
    if (state.dialog == Dialog::unsaved_changes) return std::nullopt;
    return "no question about unsaved changes is open";
}

std::optional<Argument> no_path(const EditorState&) {
    return std::string();
}

constexpr Modifiers ctrl{true, false, false};
constexpr Modifiers ctrl_shift{true, true, false};

void add_opening(std::vector<CommandSpec>& table) {
    table.push_back({.name = "new",
                     .title = "New",
                     .explanation = "Begins an empty document.",
                     .group = CommandGroup::file,
                     .shortcut = {Key::n, ctrl},
                     .act = new_document});
    table.push_back({.name = "open",
                     .title = "Open…",
                     .explanation = "Opens a file of Batten.",
                     .group = CommandGroup::file,
                     .shortcut = {Key::o, ctrl},
                     .parameters = {{"path", Kind::text, "the file; left out: asks for one", no_path}},
                     .act = open});
    table.push_back({.name = "add-file",
                     .title = "Add file",
                     .explanation = "Adds the curves of a file to the document.",
                     .group = CommandGroup::file,
                     .parameters = {{"path", Kind::text, "the file"}},
                     .edit = add_file,
                     .label = [](const EditorState&, const Arguments& arguments) {
                         return "Add file " + fs::path(arguments.text(0)).filename().string();
                     }});
    table.push_back({.name = "open-example",
                     .title = "Open example",
                     .explanation = "Opens one of the examples as an untitled document.",
                     .group = CommandGroup::file,
                     .parameters = {{"name", Kind::text, "the name of the example, as of its file"}},
                     .act = open_example});
}

void add_saving(std::vector<CommandSpec>& table) {
    table.push_back({.name = "save",
                     .title = "Save",
                     .explanation = "Saves the document to its file.",
                     .group = CommandGroup::file,
                     .shortcut = {Key::s, ctrl},
                     .act = save});
    table.push_back({.name = "save-as",
                     .title = "Save as…",
                     .explanation = "Saves the document to another file.",
                     .group = CommandGroup::file,
                     .shortcut = {Key::s, ctrl_shift},
                     .parameters = {{"path", Kind::text, "the file; left out: asks for one", no_path}},
                     .act = save_as});
    table.push_back({.name = "answer-unsaved",
                     .title = "Answer about unsaved changes",
                     .explanation = "Saves or discards unsaved changes before going on, or cancels.",
                     .group = CommandGroup::gesture,
                     .parameters = {{"answer", Kind::text, "save, discard or cancel"}},
                     .refusal = no_question,
                     .act = answer_unsaved});
    table.push_back({.name = "quit",
                     .title = "Quit",
                     .explanation = "Leaves Batten; asks about unsaved changes.",
                     .group = CommandGroup::file,
                     .shortcut = {Key::q, ctrl},
                     .act = quit});
}

}  // namespace

void add_file_commands(std::vector<CommandSpec>& table) {
    add_opening(table);
    add_saving(table);
}

}  // namespace batten::editor
