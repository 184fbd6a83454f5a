// Kills sessions at random moments, and reads what they left. BATTEN_KILLS sets how many; 40 where it is not set.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <new>
#include <random>
#include <stop_token>
#include <thread>

#include "app/editor/recovery/document_pieces.h"
#include "app/editor/recovery/journal_keeper.h"
#include "app/editor/recovery/journal_reader.h"
#include "tests/editor/random_session.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t nanoseconds_in_second = 1'000'000'000;

// When something is in a session, by two clocks that stand still where others take the machine away, as its journal
// does then. On a machine of its own a second is one on both.
struct Moment {
    std::int64_t worked = 0;  // how long the session, which never waits, had a processor, in nanoseconds
    std::int64_t synced = 0;  // how long the disk was at hand

    bool is_a_second_before(const Moment& other) const {
        return worked + nanoseconds_in_second <= other.worked && synced + nanoseconds_in_second <= other.synced;
    }
};

std::int64_t nanoseconds_worked() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return time.tv_sec * nanoseconds_in_second + time.tv_nsec;
}

// Counts `time` on by ten milliseconds for as many, or for as long as the disk takes for a byte where that is longer.
void count_while_disk_syncs(const fs::path& folder, std::atomic<std::int64_t>& time, const std::stop_token& end) {
    constexpr std::chrono::milliseconds step(10);
    const int file = open((folder / "clock").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR);
    ASSERT_GE(file, 0);
    while (!end.stop_requested()) {
        const auto next = std::chrono::steady_clock::now() + step;
        EXPECT_EQ(pwrite(file, "x", 1, 0), 1);
        EXPECT_EQ(fsync(file), 0);
        std::this_thread::sleep_until(next);
        time += std::chrono::nanoseconds(step).count();
    }
    close(file);
}

// All bits of a document.
std::uint64_t sum_of(const core::Document& document) {
    constexpr std::uint64_t prime = 0x100000001b3;
    std::uint64_t sum = 0xcbf29ce484222325;
    for (const CurvePieces& pieces : pieces_of(document))
        for (const Piece& piece : pieces) {
            for (const char byte : piece.bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * prime;
            sum = (sum ^ piece.bytes.size()) * prime;
        }
    return sum;
}

// What a session says that it committed, in memory that outlives it.
struct Testimony {
    struct Commit {
        Moment moment{};
        std::uint64_t sum = 0;
        bool is_modified = false;
    };
    std::array<Commit, 100'000> commits{};
    std::atomic<std::size_t> count = 0;
    std::atomic<std::int64_t> synced = 0;  // the clock of the disk

    void add(const EditorState& state) {
        const std::size_t i = count;
        if (i == commits.size()) return;
        commits[i] = {{nanoseconds_worked(), synced}, sum_of(state.history.present()), state.is_modified()};
        count = i + 1;
    }

    // By both clocks.
    bool is_as_old_as(std::int64_t nanoseconds) const {
        const std::size_t made = count;
        return made > 0 && commits.at(made - 1).moment.worked >= nanoseconds && synced >= nanoseconds;
    }
};

class SharedTestimony {
  public:
    SharedTestimony()
        : value_(new (mmap(nullptr, sizeof(Testimony), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
                     Testimony) {}
    SharedTestimony(const SharedTestimony&) = delete;
    SharedTestimony& operator=(const SharedTestimony&) = delete;
    ~SharedTestimony() { munmap(value_, sizeof(Testimony)); }
    Testimony* operator->() const { return value_; }

  private:
    Testimony* value_;
};

// A line of so many points, so that writing takes its time.
core::Document long_document(std::size_t count) {
    core::CurveDefinition definition{.degree = 1, .knots = {0.0}};
    for (std::size_t i = 0; i < count; ++i) {
        definition.points.emplace_back(static_cast<double>(i), static_cast<double>(i % 7));
        definition.knots.push_back(static_cast<double>(i));
    }
    definition.knots.push_back(definition.knots.back());
    core::Document document;
    core::DocumentCurve& entry = document.curves.emplace_back();
    entry.name = "long";
    entry.curve = std::make_shared<const core::Curve>(core::Curve::make(std::move(definition)).value());
    return document;
}

// Edits at full speed until it is killed. The disk has peace between records in every second session alone, as it has
// in the program; else one record follows the other, so that kills come while one is written.
[[noreturn]] void be_a_session(const fs::path& folder, unsigned seed, Testimony& testimony) {
    Editor editor(seed % 3 == 0 ? long_document(50'000) : core::parse_document(sample_text).value());
    JournalKeeper keeper(folder, {}, seed % 2 == 0 ? usual_pause : std::chrono::milliseconds(0));
    RandomSession session(seed);
    std::shared_ptr<const void> version = editor.state().history.version();
    testimony.add(editor.state());
    for (;;) {
        editor.perform(session.next(editor.state()));
        if (editor.state().history.version() == version) continue;
        version = editor.state().history.version();
        testimony.add(editor.state());
        keeper.follow(editor.state(), 1);
    }
}

// What is left of the session is one of the documents that it committed, and none that was committed more than a second
// before the next one.
void expect_survived(const fs::path& folder, const Testimony& testimony) {
    const std::size_t count = testimony.count;
    std::size_t due = 0;  // the last commit that must be on disk; the last one of all came just before the kill
    for (std::size_t i = 0; i < count; ++i)
        if (testimony.commits.at(i).moment.is_a_second_before(testimony.commits.at(count - 1).moment)) due = i;
    const std::vector<Recoverable> left = find_recoverable(folder);
    ASSERT_LE(left.size(), 1U);
    if (left.empty()) {
        const bool may_be_saved = std::any_of(testimony.commits.begin() + static_cast<std::ptrdiff_t>(due),
                                              testimony.commits.begin() + static_cast<std::ptrdiff_t>(count),
                                              [](const Testimony::Commit& commit) { return !commit.is_modified; });
        EXPECT_TRUE(may_be_saved || count == 0)
            << "nothing is left of " << count << " commits, of which " << due << " are due";
        return;
    }
    const Outcome<core::Document> found = document_of_journal(*left.front().held);
    ASSERT_TRUE(found) << found.error();
    const std::uint64_t sum = sum_of(*found);
    std::size_t place = count;
    while (place > due && testimony.commits.at(place - 1).sum != sum) --place;
    const bool is_due = place > due || testimony.commits.at(due).sum == sum;
    EXPECT_TRUE(is_due) << "the document is none of the commits from " << due << " to " << count;
}

void kill_one(unsigned seed) {
    const TemporaryFolder folder;
    const TemporaryFolder other_folder;
    const SharedTestimony testimony;
    const pid_t session = fork();
    if (session == 0) be_a_session(folder.path(), seed, *testimony.operator->());
    std::jthread clock([&](const std::stop_token& end) {
        count_while_disk_syncs(other_folder.path(), testimony.operator->()->synced, end);
    });
    std::mt19937 random(seed);
    const std::int64_t age = static_cast<std::int64_t>(random() % 2500) * 1'000'000;
    for (int looks = 0; looks < 20'000 && !testimony.operator->()->is_as_old_as(age); ++looks)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    kill(session, SIGKILL);
    clock = {};
    int status = 0;
    ASSERT_EQ(waitpid(session, &status, 0), session);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the session ended by itself";
    SCOPED_TRACE("session " + std::to_string(seed));
    expect_survived(folder.path(), *testimony.operator->());
}

// Several at once, each in a process of its own, which tells by its exit status.
TEST(JournalKill, sessions_that_are_killed_lose_nothing_older_than_a_second) {
    const char* asked = std::getenv("BATTEN_KILLS");
    const unsigned kills = asked == nullptr ? 40 : static_cast<unsigned>(std::atoi(asked));
    constexpr unsigned at_once = 4;
    std::vector<pid_t> processes;
    for (unsigned part = 0; part < at_once; ++part) {
        const pid_t process = fork();
        if (process == 0) {
            for (unsigned seed = part; seed < kills; seed += at_once) kill_one(seed);
            std::cout.flush();
            _exit(HasFailure() ? 1 : 0);
        }
        processes.push_back(process);
    }
    for (const pid_t process : processes) {
        int status = 0;
        ASSERT_EQ(waitpid(process, &status, 0), process);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0)
            << "a session lost more than a second, as told above";
    }
    std::cout << kills << " sessions were killed\n";
}

}  // namespace
}  // namespace batten::editor
