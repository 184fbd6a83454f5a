#include "app/editor/commands/groups.h"
#include "app/editor/dialog.h"

namespace batten::editor {

namespace {

// A second time closes it again.
template <Dialog dialog>
Outcome<void> toggle_dialog(EditorState& state, const Arguments&) {
    show_dialog(state, state.dialog == dialog ? Dialog::none : dialog);
    return {};
}

Outcome<void> close_dialog(EditorState& state, const Arguments&) {
    show_dialog(state, Dialog::none);
    return {};
}

Outcome<void> dismiss_message(EditorState& state, const Arguments&) {
    state.message = {};
    return {};
}

// What Escape means now, one thing at a time, the most fleeting first. An argument, so that a replay, which knows no
// previews, gives up the same.
std::optional<Argument> what_to_give_up(const EditorState& state) {
    if (state.dialog != Dialog::none) return "dialog";
    if (state.preview || state.ghost || state.message.is_error) return "preview";
    if (state.findings) return "findings";
    if (state.selection != Selection{}) return "selection";
    return "presentation";
}

Outcome<void> escape(EditorState& state, const Arguments& arguments) {
    const std::string& what = arguments.text(0);
    if (what == "dialog") {
        show_dialog(state, Dialog::none);
    } else if (what == "preview") {
        state.preview.reset();
        state.ghost.reset();
    } else if (what == "findings") {
        state.findings.reset();
    } else if (what == "selection") {
        state.selection = {};
    } else if (what == "presentation") {
        state.view.is_presenting = false;
    } else {
        return tl::unexpected("there is no giving up of '" + what +
                              "'; there are dialog, preview, findings, selection and presentation");
    }
    return {};
}

}  // namespace

void add_help_commands(std::vector<CommandSpec>& table) {
    table.push_back({.name = "command-palette",
                     .title = "Command palette…",
                     .explanation = "Finds and runs any command by its name.",
                     .group = CommandGroup::help,
                     .shortcut = {Key::p, {true, false, false}},
                     .act = toggle_dialog<Dialog::command_palette>});
    table.push_back({.name = "key-sheet",
                     .title = "Keys",
                     .explanation = "Shows all keys and gestures.",
                     .group = CommandGroup::help,
                     .shortcut = {Key::f1, {}},
                     .act = toggle_dialog<Dialog::key_sheet>});
    table.push_back({.name = "welcome",
                     .title = "Welcome and examples",
                     .explanation = "Offers the examples and recent files.",
                     .group = CommandGroup::help,
                     .act = toggle_dialog<Dialog::welcome>});
    table.push_back({.name = "about",
                     .title = "About Batten",
                     .explanation = "Says what Batten is.",
                     .group = CommandGroup::help,
                     .act = toggle_dialog<Dialog::about>});
    table.push_back({.name = "close-dialog",
                     .title = "Close dialog",
                     .explanation = "Closes what covers the window, without an answer.",
                     .group = CommandGroup::gesture,
                     .act = close_dialog});
    table.push_back({.name = "dismiss-message",
                     .title = "Dismiss message",
                     .explanation = "Takes the message away.",
                     .group = CommandGroup::gesture,
                     .act = dismiss_message});
    table.push_back(
        {.name = "escape",
         .title = "Cancel",
         .explanation =
             "Closes a dialog, or gives up the gesture under way and the old shape shown, or else the selection.",
         .group = CommandGroup::edit,
         .shortcut = {Key::escape, {}},
         .parameters = {{"what", ParameterKind::text, "dialog, preview, selection or presentation", what_to_give_up}},
         .act = escape});
}

}  // namespace batten::editor
