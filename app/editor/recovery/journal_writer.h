/// Keeps the journal of a session on disk, in a thread of its own.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "app/editor/recovery/held_journal.h"
#include "app/editor/recovery/journal_format.h"
#include "core/document/document.h"

namespace batten::editor {

/// The document as it was committed, for the journal.
struct JournalEntry {
    core::Document document;
    JournalFacts facts;
    std::shared_ptr<HeldJournal> held{};  ///< goes on with this journal; null: with the one it has, or a new one
};

/// The disk has so much peace between two records.
inline constexpr std::chrono::milliseconds usual_pause(250);

/// Calls return at once, whatever the size of the document: what is asked for last takes the place of what waits.
class JournalWriter {
  public:
    /// Journals stand in `folder`. `wake` is called from the thread when there is trouble to tell.
    explicit JournalWriter(std::filesystem::path folder, std::function<void()> wake = {},
                           std::chrono::milliseconds pause = usual_pause);

    /// First does what waits.
    ~JournalWriter();

    /// Has the document written, within half a second where the disk is as quick.
    void write(JournalEntry entry);

    /// Has the journal removed: nothing is unsaved.
    void clear();

    /// Waits until all that was asked for is done.
    void finish();

    /// Why the journal could not be written, as a whole sentence, once.
    std::optional<std::string> take_trouble();

  private:
    struct Shared;
    static void work(Shared& shared, std::filesystem::path folder, const std::function<void()>& wake,
                     std::chrono::milliseconds pause);

    std::unique_ptr<Shared> shared_;
    std::jthread thread_;
};

}  // namespace batten::editor
