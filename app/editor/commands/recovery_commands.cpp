#include "app/editor/commands/recovery_commands.h"

#include <algorithm>

#include "app/editor/commands/file_acts.h"
#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/recovery/held_journal.h"
#include "app/editor/state/show_dialog.h"

namespace batten::editor {

namespace {

Outcome<void> show_recovery(EditorState& state, const ShowRecovery&) {
    show_dialog(state, Dialog::recovery);
    return {};
}

// Where no document is open, to what a start without any begins with.
void close_recovery(EditorState& state) {
    const bool has_document = !state.history.present().curves.empty() || state.is_modified() || !state.path.empty();
    show_dialog(state, has_document ? Dialog::none : Dialog::welcome);
}

Outcome<void> recover_one(EditorState& state, const Recover& command) {
    return ask_or_proceed(state, command);
}

Outcome<void> discard_recovery(EditorState& state, const DiscardRecovery& command) {
    const auto found = std::ranges::find(state.recoverable, command.journal, &Recoverable::journal);
    if (found == state.recoverable.end()) return tl::unexpected(Refusal("there is no such document to discard"));
    if (found->held != nullptr) found->held->remove();
    state.recoverable.erase(found);
    if (state.recoverable.empty() && state.dialog == Dialog::recovery) close_recovery(state);
    return {};
}

Outcome<void> leave_recovery(EditorState& state, const LeaveRecovery&) {
    close_recovery(state);
    return {};
}

std::optional<Refusal> nothing_to_recover(const EditorState& state) {
    if (!state.recoverable.empty()) return std::nullopt;
    return "there is no unsaved document to recover";
}

std::optional<Refusal> no_recovery_shown(const EditorState& state) {
    if (state.dialog == Dialog::recovery) return std::nullopt;
    return "no documents are offered";
}

}  // namespace

const CommandSpec& ShowRecovery::spec() {
    static const CommandSpec spec{.name = "show-recovery",
                                  .title = "Recover…",
                                  .explanation = "Offers the documents that a session left unsaved.",
                                  .synonyms = "crash lost restore journal",
                                  .group = CommandGroup::file,
                                  .offered = in_the_window,
                                  .refusal = nothing_to_recover,
                                  .run = body_of<show_recovery>,
                                  .is_logged = false};
    return spec;
}

const CommandSpec& Recover::spec() {
    static const CommandSpec spec{.name = "recover",
                                  .title = "Recover",
                                  .explanation = "Opens a document that a session left unsaved, up to its last edit.",
                                  .group = CommandGroup::gesture,
                                  .offered = nowhere,
                                  .fields = {field::file<&Recover::journal>("journal", "the journal of the document")},
                                  .refusal = nothing_to_recover,
                                  .run = body_of<recover_one>,
                                  .at_work = "Recovering the document"};
    return spec;
}

const CommandSpec& DiscardRecovery::spec() {
    static const CommandSpec spec{
        .name = "discard-recovery",
        .title = "Discard",
        .explanation = "Gives up a document that a session left unsaved.",
        .group = CommandGroup::gesture,
        .offered = nowhere,
        .fields = {field::file<&DiscardRecovery::journal>("journal", "the journal of the document")},
        .refusal = nothing_to_recover,
        .run = body_of<discard_recovery>,
        .is_logged = false};
    return spec;
}

const CommandSpec& LeaveRecovery::spec() {
    static const CommandSpec spec{.name = "leave-recovery",
                                  .title = "Later",
                                  .explanation = "Keeps the documents that a session left unsaved for later.",
                                  .group = CommandGroup::gesture,
                                  .offered = nowhere,
                                  .refusal = no_recovery_shown,
                                  .run = body_of<leave_recovery>,
                                  .is_logged = false};
    return spec;
}

void add_recovery_commands(CommandTable& table) {
    add_all<ShowRecovery, Recover, DiscardRecovery, LeaveRecovery>(table);
}

}  // namespace batten::editor
