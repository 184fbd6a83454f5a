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

struct Clear {};
using Job = std::variant<std::monostate, Clear, JournalEntry>;

// The journal as it stands on disk, and what it was made of.
class Journal {
  public:
    explicit Journal(fs::path folder) : folder_(std::move(folder)) {}

    Outcome<void> write(const JournalEntry& entry) {
        const std::shared_ptr<HeldJournal> before = journal_;
        const bool goes_on = journal_ != nullptr && (entry.held == nullptr || entry.held == journal_);
        if (!goes_on) journal_ = entry.held != nullptr ? entry.held : new_journal();
        const bool can_append = goes_on && journal_->is_there() && !pieces_.empty();
        DocumentPieces pieces = pieces_of(entry.document);
        Outcome<void> written = can_append && !is_too_long() ? append(entry.facts, pieces) : begin(entry.facts, pieces);
        if (!written && can_append && is_too_long()) written = append(entry.facts, pieces);
        if (!written) return written;
        pieces_ = std::move(pieces);
        if (!goes_on && before != nullptr) before->remove();
        return {};
    }

    void clear() {
        if (journal_ != nullptr) journal_->remove();
        pieces_.clear();
    }

  private:
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

    Outcome<void> begin(const JournalFacts& facts, const DocumentPieces& pieces) {
        RecordWriter records;
        std::string content(journal_head());
        content += records.written(facts, delta_between({}, pieces));
        return journal_->replace(content).map([&] {
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
    Job job;  // that waits
    bool is_at_work = false;
    bool is_hurried = false;  // somebody waits
    bool is_ending = false;
    std::optional<std::string> trouble;
    bool has_told = false;
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
    const auto has_job = [&] { return !std::holds_alternative<std::monostate>(shared.job); };
    for (;;) {
        shared.changed.wait(lock, [&] { return has_job() || shared.is_ending; });
        if (!has_job()) return;
        const Job job = std::exchange(shared.job, Job());
        shared.is_at_work = true;
        lock.unlock();
        const Outcome<void> outcome = done(journal, job);
        lock.lock();
        shared.is_at_work = false;
        if (!outcome && !std::exchange(shared.has_told, true)) {
            shared.trouble = core::sentence(
                "Unsaved changes would be lost in a crash, because no recovery journal can be written: {reason}",
                {{"reason", outcome.error()}});
            if (wake) wake();
        }
        shared.changed.notify_all();
        shared.changed.wait_for(lock, pause, [&] { return shared.is_hurried || shared.is_ending; });
    }
}

void JournalWriter::write(JournalEntry entry) {
    const std::lock_guard lock(shared_->mutex);
    shared_->job = std::move(entry);
    shared_->changed.notify_all();
}

void JournalWriter::clear() {
    const std::lock_guard lock(shared_->mutex);
    shared_->job = Clear{};
    shared_->changed.notify_all();
}

void JournalWriter::finish() {
    std::unique_lock lock(shared_->mutex);
    shared_->is_hurried = true;
    shared_->changed.notify_all();
    shared_->changed.wait(lock,
                          [&] { return !shared_->is_at_work && std::holds_alternative<std::monostate>(shared_->job); });
    shared_->is_hurried = false;
}

std::optional<std::string> JournalWriter::take_trouble() {
    const std::lock_guard lock(shared_->mutex);
    return std::exchange(shared_->trouble, std::nullopt);
}

}  // namespace batten::editor
