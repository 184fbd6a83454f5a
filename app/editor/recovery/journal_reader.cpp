#include "app/editor/recovery/journal_reader.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <new>

#include "app/editor/recovery/piece_delta.h"
#include "app/editor/state/same_document.h"
#include "app/editor/state/user_folder.h"
#include "core/base/sentence.h"
#include "core/document/native_file.h"

namespace batten::editor {

namespace {

namespace fs = std::filesystem;

constexpr const char* journal_ending = ".journal";

// What begins as whole records do, as far as the file goes: what is damaged or empty may seem endless.
Outcome<std::string> content_of_records(const HeldJournal& journal) {
    Outcome<std::string> content = journal.part(0, journal_head().size());
    if (!content || *content != journal_head()) return content;
    for (;;) {
        const auto end = static_cast<std::int64_t>(content->size());
        const Outcome<std::string> head = journal.part(end, record_head_bytes);
        if (!head) return tl::unexpected(head.error());
        const std::uint64_t bytes = record_bytes(*head);
        const std::int64_t last = std::min(journal.size(), most_journal_bytes) - end - std::int64_t{record_head_bytes};
        if (bytes == 0 || last < 0 || bytes > static_cast<std::uint64_t>(last)) return content;
        Outcome<std::string> record = journal.part(end, record_head_bytes + bytes);
        if (!record) return record;
        *content += *record;
    }
}

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

// Adds what the journal has. Removes one of which nothing is to be offered.
void look_into(std::shared_ptr<HeldJournal> journal, LeftJournals& left) {
    const Outcome<std::string> content = content_of_records(*journal);
    if (!content) return;
    const RecordReader reader(*content);
    if (!reader.is_known() && journal->size() > 0) {
        ++left.unknown_count;
        return;
    }
    const std::optional<JournalFacts> facts = last_facts(reader);
    if (!facts || is_saved_already(*journal, *facts)) {
        journal->remove();
        return;
    }
    const fs::path path = journal->path();
    left.documents.push_back({path, facts->file, facts->stamp, facts->seconds, facts->edit_count, std::move(journal)});
}

// One that another user wrote, for instance.
bool is_kept_from_us(const fs::path& path) {
    return faccessat(AT_FDCWD, path.c_str(), R_OK | W_OK, AT_EACCESS) != 0 && errno == EACCES;
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
    const Outcome<std::string> content = content_of_records(journal);
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

LeftJournals left_journals(const fs::path& folder) {
    LeftJournals left;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        if (entry->path().extension() == ".new") remove_left_over(*entry);
        if (entry->path().extension() != journal_ending) continue;
        try {
            if (auto journal = HeldJournal::take(entry->path()))
                look_into(std::move(journal), left);
            else if (is_kept_from_us(entry->path()))
                ++left.unknown_count;
        } catch (const std::bad_alloc&) {  // it stays for a session that has the memory
            ++left.unknown_count;
        }
    }
    std::ranges::stable_sort(left.documents, std::greater(), &Recoverable::seconds);
    return left;
}

std::string words_of_unknown_journals(std::size_t count, const fs::path& folder) {
    if (count == 1)
        return core::sentence(
            "A recovery journal in {folder} cannot be read: it is of another version of Batten or another user, or "
            "damaged",
            {{"folder", folder.string()}});
    return core::sentence(
        "{count} recovery journals in {folder} cannot be read: they are of other versions of Batten or other users, or "
        "damaged",
        {{"count", count}, {"folder", folder.string()}});
}

}  // namespace batten::editor
