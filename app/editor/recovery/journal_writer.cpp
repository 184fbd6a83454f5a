#include "app/editor/recovery/journal_writer.h"

#include <fmt/core.h>
#include <unistd.h>

#include <condition_variable>
#include <csignal>
#include <exception>
#include <mutex>
#include <variant>

#include "app/editor/recovery/piece_delta.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds pause_after_trouble(2);

struct Clear {};
using Job = std::variant<std::monostate, Clear, JournalEntry>;

// The journal as it stands on disk, and what it was made of.
class Journal {
  public:
    explicit Journal(fs::path folder) : folder_(std::move(folder)) {}

    Outcome<void> write(const JournalEntry& entry) {
        DocumentPieces pieces = pieces_of(entry.document);
        const bool goes_on = journal_ != nullptr && (entry.held == nullptr || entry.held == journal_);
        if (!goes_on) return go_over_to(entry.held != nullptr ? entry.held : new_journal(), entry.facts, pieces);
        const bool can_append = journal_->is_whole() && !pieces_.empty();
        Outcome<void> written =
            can_append && !is_too_long() ? append(entry.facts, pieces) : begin(*journal_, entry.facts, pieces);
        if (!written && can_append && is_too_long()) written = append(entry.facts, pieces);
        if (written) pieces_ = std::move(pieces);
        return written;
    }

    bool is_own(const std::shared_ptr<HeldJournal>& journal) const { return journal == journal_; }

    void clear() {
        if (journal_ != nullptr) journal_->remove();
        pieces_.clear();
    }

  private:
    // The journal before is the own one until the other has the document.
    Outcome<void> go_over_to(std::shared_ptr<HeldJournal> journal, const JournalFacts& facts, DocumentPieces& pieces) {
        Outcome<void> begun = begin(*journal, facts, pieces);
        if (!begun) return begun;
        const std::shared_ptr<HeldJournal> before = std::exchange(journal_, std::move(journal));
        if (before != nullptr) before->remove();
        pieces_ = std::move(pieces);
        return {};
    }

    std::shared_ptr<HeldJournal> new_journal() const {
        const auto now = std::chrono::system_clock::now().time_since_epoch().count();
        return std::make_shared<HeldJournal>(folder_ / fmt::format("{}-{}.journal", getpid(), now));
    }

    // What is read back one record after the other must not take long.
    bool is_too_long() const {
        constexpr std::size_t least_bytes = std::size_t{16} << 20U;
        constexpr std::size_t most_records = 500;
        return appended_bytes_ > std::max(least_bytes, 2 * whole_bytes_) || appended_records_ > most_records;
    }

    Outcome<void> begin(HeldJournal& journal, const JournalFacts& facts, const DocumentPieces& pieces) {
        RecordWriter records;
        std::string content(journal_head());
        content += records.written(facts, delta_between({}, pieces));
        return journal.replace(content).map([&] {
            records_ = records;
            whole_bytes_ = content.size();
            appended_bytes_ = 0;
            appended_records_ = 0;
        });
    }

    Outcome<void> append(const JournalFacts& facts, const DocumentPieces& pieces) {
        const std::string record = records_.written(facts, delta_between(pieces_, pieces));
        Outcome<void> appended = journal_->append(record);
        if (!appended) {
            records_.take_back();
            return appended;
        }
        appended_bytes_ += record.size();
        ++appended_records_;
        return {};
    }

    fs::path folder_;
    std::shared_ptr<HeldJournal> journal_;
    DocumentPieces pieces_;  // of the last record
    RecordWriter records_;
    std::size_t whole_bytes_ = 0;
    std::size_t appended_bytes_ = 0;
    std::size_t appended_records_ = 0;
};

Outcome<void> done(Journal& journal, const Job& job) {
    try {
        if (const auto* entry = std::get_if<JournalEntry>(&job)) return journal.write(*entry);
        if (std::holds_alternative<Clear>(job)) journal.clear();
        return {};
    } catch (const std::exception& error) {  // memory that is lacking
        return tl::unexpected(Refusal(error.what()));
    }
}

void hold_all_signals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

struct JournalWriter::Shared {
    std::mutex mutex;
    std::condition_variable changed;
    Job job;                                             // that waits
    std::vector<std::shared_ptr<HeldJournal>> given_up;  // by jobs that waited and were replaced
    bool is_at_work = false;
    bool is_hurried = false;  // somebody waits
    bool is_ending = false;
    std::optional<std::string> trouble;
    bool has_told = false;

    bool has_job() const { return !std::holds_alternative<std::monostate>(job); }

    // Has `next` waiting in place of the job that waits.
    void replace_job(Job next) {
        const std::lock_guard lock(mutex);
        const auto* const waiting = std::get_if<JournalEntry>(&job);
        const auto* const entry = std::get_if<JournalEntry>(&next);
        if (waiting != nullptr && waiting->held != nullptr && (entry == nullptr || entry->held != waiting->held))
            given_up.push_back(waiting->held);
        if (entry == nullptr) has_told = false;
        job = std::move(next);
        changed.notify_all();
    }

    // What came to nothing is tried again, unless something newer waits or nobody can wait for it.
    void try_again(Job failed, const std::vector<std::shared_ptr<HeldJournal>>& not_removed) {
        given_up.insert(given_up.end(), not_removed.begin(), not_removed.end());
        if (!has_job() && !is_hurried && !is_ending) job = std::move(failed);
    }

    // Trouble is told once until nothing is unsaved any more.
    void tell(const Outcome<void>& outcome, const std::function<void()>& wake) {
        if (outcome || std::exchange(has_told, true)) return;
        trouble = core::sentence(
            "Unsaved changes would be lost in a crash, because no recovery journal can be written: {reason}",
            {{"reason", outcome.error()}});
        if (wake) wake();
    }
};

JournalWriter::JournalWriter(fs::path folder, std::function<void()> wake, std::chrono::milliseconds pause)
    : shared_(std::make_unique<Shared>()),
      thread_([shared = shared_.get(), folder = std::move(folder), wake = std::move(wake), pause] {
          work(*shared, folder, wake, pause);
      }) {}

JournalWriter::~JournalWriter() {
    const std::lock_guard lock(shared_->mutex);
    shared_->is_ending = true;
    shared_->changed.notify_all();
}

void JournalWriter::work(Shared& shared, fs::path folder, const std::function<void()>& wake,
                         std::chrono::milliseconds pause) {
    hold_all_signals();
    Journal journal(std::move(folder));
    std::unique_lock lock(shared.mutex);
    for (;;) {
        shared.changed.wait(lock, [&] { return shared.has_job() || shared.is_ending; });
        if (!shared.has_job()) return;
        Job job = std::exchange(shared.job, Job());
        const auto given_up = std::exchange(shared.given_up, {});
        shared.is_at_work = true;
        lock.unlock();
        const Outcome<void> outcome = done(journal, job);
        for (const auto& held : given_up)
            if (outcome && !journal.is_own(held)) held->remove();
        lock.lock();
        shared.is_at_work = false;
        if (!outcome) shared.try_again(std::move(job), given_up);
        shared.tell(outcome, wake);
        shared.changed.notify_all();
        shared.changed.wait_for(lock, outcome ? pause : pause_after_trouble,
                                [&] { return shared.is_hurried || shared.is_ending; });
    }
}

void JournalWriter::write(JournalEntry entry) {
    shared_->replace_job(std::move(entry));
}

void JournalWriter::clear() {
    shared_->replace_job(Clear{});
}

void JournalWriter::finish() {
    std::unique_lock lock(shared_->mutex);
    shared_->is_hurried = true;
    shared_->changed.notify_all();
    shared_->changed.wait(lock, [&] { return !shared_->is_at_work && !shared_->has_job(); });
    shared_->is_hurried = false;
}

std::optional<std::string> JournalWriter::take_trouble() {
    const std::lock_guard lock(shared_->mutex);
    return std::exchange(shared_->trouble, std::nullopt);
}

}  // namespace batten::editor
