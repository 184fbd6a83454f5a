/// Reads back what journals hold.
#pragma once

#include <optional>
#include <vector>

#include "app/editor/recovery/held_journal.h"
#include "app/editor/recovery/journal_format.h"
#include "core/base/progress.h"
#include "core/document/document.h"

namespace batten::editor {

/// The document of the last whole record. Refused where none is whole. `progress` is told how much is read.
[[nodiscard]] Outcome<core::Document> document_of_journal(const HeldJournal& journal,
                                                          const core::Progress& progress = {});

/// Where sessions of the user keep their journals: $XDG_STATE_HOME/batten/recovery, else under ~/.local/state; empty
/// without a home.
std::filesystem::path recovery_folder();

/// What sessions that did not end well left in `folder`, edited last first; the journals are held. Those with nothing
/// in them, and those whose document is saved in its file as it is, are removed; those of other versions stay.
std::vector<Recoverable> find_recoverable(const std::filesystem::path& folder);

}  // namespace batten::editor
