/// Reads back what journals hold.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
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

/// Journals have at most so many bytes, so that the memory for reading them has a bound; what is beyond is not read.
inline constexpr std::int64_t most_journal_bytes = std::int64_t{4} << 30U;

/// What sessions that did not end well left in a folder.
struct LeftJournals {
    std::vector<Recoverable> documents;  ///< edited last first; their journals are held
    std::size_t unknown_count = 0;       ///< journals that this version cannot read, which stay
};

/// Looks through `folder`. Journals with nothing in them, and those whose document is saved in its file as it is, are
/// removed. What is no whole record is never read, however large the file.
LeftJournals left_journals(const std::filesystem::path& folder);

/// The documents of left_journals.
inline std::vector<Recoverable> find_recoverable(const std::filesystem::path& folder) {
    return left_journals(folder).documents;
}

/// Tells of `count` journals in `folder` that this version cannot read.
std::string words_of_unknown_journals(std::size_t count, const std::filesystem::path& folder);

}  // namespace batten::editor
