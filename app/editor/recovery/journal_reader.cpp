#include "app/editor/recovery/journal_reader.h"

#include <algorithm>
#include <chrono>

#include "app/editor/recovery/piece_delta.h"
#include "app/editor/state/same_document.h"
#include "app/editor/state/user_folder.h"
#include "core/document/native_file.h"

namespace batten::editor {

namespace {

namespace fs = std::filesystem;

constexpr const char* journal_ending = ".journal";

// The facts of the last whole record.
std::optional<JournalFacts> last_facts(RecordReader reader) {
    std::optional<JournalFacts> facts;
    while (const std::optional<JournalRecord> record = reader.next()) facts = record->facts;
    return facts;
}

// Whether the document was saved, but the session had no time left to remove its journal. The file is read only where
// it was written after the last edit.
bool is_saved_already(const HeldJournal& journal, const JournalFacts& facts) {
    const std::optional<core::FileStamp> stamp = core::file_stamp(facts.file);
    if (facts.file.empty() || !stamp || stamp == facts.stamp || stamp->seconds < facts.seconds) return false;
    const auto saved = core::load_document(facts.file);
    Outcome<core::Document> document = document_of_journal(journal);
    if (!saved || !document) return false;
    document->view = saved->view;  // saved as it was seen then
    return has_same_content(*saved, *document);
}

// Removes a journal of which nothing is to be offered.
std::optional<Recoverable> offered(std::shared_ptr<HeldJournal> journal) {
    const Outcome<std::string> content = journal->content();
    if (!content) return std::nullopt;
    const RecordReader reader(*content);
    if (!reader.is_known() && !content->empty()) return std::nullopt;
    const std::optional<JournalFacts> facts = last_facts(reader);
    if (!facts || is_saved_already(*journal, *facts)) {
        journal->remove();
        return std::nullopt;
    }
    const fs::path path = journal->path();
    return Recoverable{path, facts->file, facts->stamp, facts->seconds, facts->edit_count, std::move(journal)};
}

// A new journal that has not taken the place of an old one, and is too old to do so now.
void remove_left_over(const fs::directory_entry& entry) {
    constexpr std::chrono::minutes time_to_write(10);
    std::error_code error;
    const fs::file_time_type written = entry.last_write_time(error);
    if (!error && fs::file_time_type::clock::now() - written > time_to_write) fs::remove(entry.path(), error);
}

}  // namespace

Outcome<core::Document> document_of_journal(const HeldJournal& journal, const core::Progress& progress) {
    const Outcome<std::string> content = journal.content();
    if (!content) return tl::unexpected(content.error());
    RecordReader reader(*content);
    DocumentPieces pieces;
    while (const std::optional<JournalRecord> record = reader.next()) {
        Outcome<DocumentPieces> next = with_delta(pieces, record->delta);
        if (!next) return tl::unexpected(next.error());
        pieces = *std::move(next);
        core::tell(progress, static_cast<std::size_t>(record->delta.data() - content->data()), content->size() + 1);
    }
    if (!pieces.empty()) return document_of(pieces);
    return tl::unexpected(Refusal("the journal holds no document"));
}

fs::path recovery_folder() {
    const fs::path folder = user_folder("XDG_STATE_HOME", ".local/state");
    return folder.empty() ? fs::path() : folder / "batten" / "recovery";
}

std::vector<Recoverable> find_recoverable(const fs::path& folder) {
    std::vector<Recoverable> found;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        if (entry->path().extension() == ".new") remove_left_over(*entry);
        if (entry->path().extension() != journal_ending) continue;
        auto journal = HeldJournal::take(entry->path());
        if (journal == nullptr) continue;
        if (std::optional<Recoverable> one = offered(std::move(journal))) found.push_back(*std::move(one));
    }
    std::ranges::stable_sort(found, std::greater(), &Recoverable::seconds);
    return found;
}

}  // namespace batten::editor
