#include "app/editor/commands/help_commands.h"

#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/show_dialog.h"

namespace batten::editor {

namespace {

// A second time closes it again.
template <class Command, Dialog dialog>
Outcome<void> toggle_dialog(EditorState& state, const Command&) {
    show_dialog(state, state.dialog == dialog ? Dialog::none : dialog);
    return {};
}

Outcome<void> close_dialog(EditorState& state, const CloseDialog&) {
    show_dialog(state, Dialog::none);
    return {};
}

Outcome<void> dismiss_message(EditorState& state, const DismissMessage&) {
    state.message = {};
    return {};
}

Outcome<void> clear_findings(EditorState& state, const ClearFindings&) {
    state.findings.reset();
    return {};
}

std::optional<Refusal> no_findings(const EditorState& state) {
    if (state.findings) return std::nullopt;
    return "no results are shown";
}

// What Escape means now, one thing at a time. A field, so that a replay, which knows no previews, gives up the same.
Escapable what_to_give_up(const EditorState& state) {
    if (state.dialog != Dialog::none) return Escapable::dialog;
    if (state.axis_pick) return Escapable::tool;
    if (state.preview) return Escapable::preview;
    if (state.tool != Tool::select || state.gauge) return Escapable::tool;
    if (state.ghost || state.message.is_error) return Escapable::preview;
    if (state.findings) return Escapable::findings;
    if (state.selection != Selection{}) return Escapable::selection;
    return Escapable::presentation;
}

Outcome<void> escape(EditorState& state, const Escape& command) {
    switch (command.what) {
        case Escapable::dialog:
            show_dialog(state, Dialog::none);
            break;
        case Escapable::preview:
            state.preview.reset();
            state.ghost.reset();
            break;
        case Escapable::tool:
            take_tool(state, Tool::select);
            state.gauge.reset();
            break;
        case Escapable::findings:
            state.findings.reset();
            break;
        case Escapable::selection:
            state.selection = {};
            break;
        case Escapable::presentation:
            state.view.is_presenting = false;
            break;
    }
    return {};
}

}  // namespace

const CommandSpec& TogglePalette::spec() {
    static const CommandSpec spec{.name = "command-palette",
                                  .title = "Command palette…",
                                  .explanation = "Finds and runs any command by name.",
                                  .synonyms = "search",
                                  .group = CommandGroup::help,
                                  .offered = in_the_window,
                                  .shortcut = {Key::p, {true, false, false}},
                                  .run = body_of<toggle_dialog<TogglePalette, Dialog::command_palette>>,
                                  .is_logged = false};
    return spec;
}

const CommandSpec& ToggleKeySheet::spec() {
    static const CommandSpec spec{.name = "key-sheet",
                                  .title = "Keys",
                                  .explanation = "Shows all keys and gestures.",
                                  .synonyms = "shortcuts help mouse",
                                  .group = CommandGroup::help,
                                  .offered = in_the_window,
                                  .shortcut = {Key::f1, {}},
                                  .run = body_of<toggle_dialog<ToggleKeySheet, Dialog::key_sheet>>,
                                  .is_logged = false};
    return spec;
}

const CommandSpec& ToggleWelcome::spec() {
    static const CommandSpec spec{.name = "welcome",
                                  .title = "Welcome and examples",
                                  .explanation = "Offers the examples and recent files.",
                                  .synonyms = "start",
                                  .group = CommandGroup::help,
                                  .offered = in_the_window,
                                  .run = body_of<toggle_dialog<ToggleWelcome, Dialog::welcome>>,
                                  .is_logged = false};
    return spec;
}

const CommandSpec& ToggleAbout::spec() {
    static const CommandSpec spec{.name = "about",
                                  .title = "About Batten",
                                  .explanation = "Says what Batten is and which version this is.",
                                  .synonyms = "version license",
                                  .group = CommandGroup::help,
                                  .offered = in_the_window,
                                  .run = body_of<toggle_dialog<ToggleAbout, Dialog::about>>,
                                  .is_logged = false};
    return spec;
}

const CommandSpec& CloseDialog::spec() {
    static const CommandSpec spec{.name = "close-dialog",
                                  .title = "Close dialog",
                                  .explanation = "Closes the dialog without an answer.",
                                  .group = CommandGroup::gesture,
                                  .offered = nowhere,
                                  .run = body_of<close_dialog>,
                                  .is_logged = false};
    return spec;
}

const CommandSpec& DismissMessage::spec() {
    static const CommandSpec spec{.name = "dismiss-message",
                                  .title = "Dismiss message",
                                  .explanation = "Takes the message away.",
                                  .group = CommandGroup::gesture,
                                  .offered = nowhere,
                                  .run = body_of<dismiss_message>,
                                  .is_logged = false};
    return spec;
}

const CommandSpec& ClearFindings::spec() {
    static const CommandSpec spec{.name = "clear-findings",
                                  .title = "Clear results",
                                  .explanation = "Forgets the results shown and their marks on the canvas.",
                                  .group = CommandGroup::analyze,
                                  .offered = in_the_window,
                                  .refusal = no_findings,
                                  .run = body_of<clear_findings>};
    return spec;
}

const CommandSpec& Escape::spec() {
    static const CommandSpec spec{
        .name = "escape",
        .title = "Cancel",
        .explanation =
            "Closes a dialog, or gives up the gesture under way, or the tool, or the results shown, or the selection.",
        .group = CommandGroup::edit,
        .offered = {.menu = false, .scripts = false},
        .shortcut = {Key::escape, {}},
        .fields = {field::choice<&Escape::what>("what", "what to give up").suggesting<what_to_give_up>().unasked()},
        .run = body_of<escape>};
    return spec;
}

void add_help_commands(CommandTable& table) {
    add_all<TogglePalette, ToggleKeySheet, ToggleWelcome, ToggleAbout>(table);
    add_all<CloseDialog, DismissMessage, ClearFindings, Escape>(table);
}

}  // namespace batten::editor
