#include "app/editor/recovery/journal_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "app/editor/recovery/journal_writer.h"
#include "app/editor/state/same_document.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

namespace fs = std::filesystem;

class Reader : public ::testing::Test {
  protected:
    // Leaves the journal of a session behind that edited `document` at `seconds`.
    void leave(const core::Document& document, std::int64_t seconds, const fs::path& file = {}) const {
        JournalWriter writer(folder_.path());
        writer.write({document, {file, core::file_stamp(file), seconds, 3}});
    }
    static core::Document sample() { return core::parse_document(sample_text).value(); }
    std::size_t journal_count() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
    }

    TemporaryFolder folder_;
};

TEST_F(Reader, offers_the_one_edited_last_first) {
    leave(sample(), 100);
    leave(sample(), 300, "/nowhere/b.json");
    leave(sample(), 200);
    const auto found = find_recoverable(folder_.path());
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].seconds, 300);
    EXPECT_EQ(found[0].file, "/nowhere/b.json");
    EXPECT_EQ(found[1].seconds, 200);
    EXPECT_EQ(found[2].seconds, 100);
    EXPECT_EQ(found[2].edit_count, 3U);
    EXPECT_TRUE(find_recoverable(folder_.path()).empty()) << "they are held";
}

TEST_F(Reader, removes_journals_without_a_document_and_leaves_what_it_does_not_know) {
    leave(sample(), 100);
    folder_.write("empty.journal", "");
    folder_.write("torn.journal", std::string(journal_head()) + "torn");
    std::string newer(journal_head());
    newer[8] = 2;
    folder_.write("newer.journal", newer + "of another version");
    folder_.write("notes.txt", "mine");
    const LeftJournals left = left_journals(folder_.path());
    EXPECT_EQ(left.documents.size(), 1U);
    EXPECT_EQ(left.unknown_count, 1U);
    EXPECT_FALSE(fs::exists(folder_.path() / "empty.journal"));
    EXPECT_FALSE(fs::exists(folder_.path() / "torn.journal"));
    EXPECT_TRUE(fs::exists(folder_.path() / "newer.journal"));
    EXPECT_TRUE(fs::exists(folder_.path() / "notes.txt"));
}

TEST_F(Reader, tells_of_journals_of_other_versions) {
    EXPECT_EQ(words_of_unknown_journals(1, "/state/recovery"),
              "A recovery journal in /state/recovery cannot be read: it is of another version of Batten or another "
              "user, or damaged");
    EXPECT_EQ(words_of_unknown_journals(2, "/state/recovery"),
              "2 recovery journals in /state/recovery cannot be read: they are of other versions of Batten or other "
              "users, or damaged");
}

TEST_F(Reader, tells_of_journals_that_this_user_may_not_read) {
    leave(sample(), 100);
    const fs::path theirs = folder_.write("theirs.journal", std::string(journal_head()));
    fs::permissions(theirs, fs::perms::none);
    fs::permissions(folder_.path(), fs::perms::all);
    constexpr uid_t nobody = 65534;
    const uid_t user = geteuid();
    ASSERT_EQ(seteuid(user == 0 ? nobody : user), 0);
    const LeftJournals left = left_journals(folder_.path());
    ASSERT_EQ(seteuid(user), 0);
    EXPECT_EQ(left.unknown_count, user == 0 ? 2U : 1U) << "for root the other one is another user's, too";
    EXPECT_TRUE(fs::exists(theirs));
}

// A file system that lost what was written last fills files with zeros, or with anything.
TEST_F(Reader, reads_no_more_than_whole_records_of_files_that_seem_endless) {
    constexpr std::uintmax_t terabyte = std::uintmax_t{1} << 40U;
    leave(sample(), 100);
    leave(sample(), 200);
    for (const auto& entry : fs::directory_iterator(folder_.path())) fs::resize_file(entry.path(), terabyte);
    const fs::path empty = folder_.write("3.journal", "");
    fs::resize_file(empty, terabyte);
    // A record of half a terabyte.
    const std::string size("\0\0\0\0\x80\0\0\0", 8);
    const fs::path lying = folder_.write("4.journal", std::string(journal_head()) + size);
    fs::resize_file(lying, terabyte);
    const LeftJournals left = left_journals(folder_.path());
    ASSERT_EQ(left.documents.size(), 2U);
    EXPECT_EQ(left.documents[0].seconds, 200);
    EXPECT_TRUE(is_same_document(document_of_journal(*left.documents[1].held).value(), sample()));
    EXPECT_EQ(left.unknown_count, 1U) << "nothing says that it is none of another version";
    EXPECT_TRUE(fs::exists(empty));
    EXPECT_FALSE(fs::exists(lying));
}

TEST_F(Reader, removes_old_files_that_never_became_journals) {
    const fs::path old = folder_.write("1.journal.new", "half");
    const fs::path fresh = folder_.write("2.journal.new", "half");
    fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(1));
    EXPECT_TRUE(find_recoverable(folder_.path()).empty());
    EXPECT_FALSE(fs::exists(old));
    EXPECT_TRUE(fs::exists(fresh));
}

TEST_F(Reader, removes_silently_what_was_saved_before_the_end) {
    const TemporaryFolder elsewhere;
    const fs::path file = elsewhere.write("wave.json", sample_text);
    core::Document edited = sample();
    edited.title = "edited";
    leave(edited, 100, file);
    ASSERT_TRUE(core::save_document(edited, file));
    EXPECT_TRUE(find_recoverable(folder_.path()).empty());
    EXPECT_EQ(journal_count(), 0U);
    // Another program saved something else there.
    leave(edited, 100, file);
    ASSERT_TRUE(core::save_document(sample(), file));
    EXPECT_EQ(find_recoverable(folder_.path()).size(), 1U);
}

TEST_F(Reader, of_a_folder_that_is_not_there_finds_nothing) {
    EXPECT_TRUE(find_recoverable(folder_.path() / "nowhere").empty());
    EXPECT_TRUE(find_recoverable("").empty());
    EXPECT_TRUE(find_recoverable(folder_.write("file", "")).empty());
}

TEST_F(Reader, tells_where_journals_stand) {
    setenv("XDG_STATE_HOME", "/state", 1);
    EXPECT_EQ(recovery_folder(), "/state/batten/recovery");
    setenv("XDG_STATE_HOME", "not absolute", 1);
    setenv("HOME", "/home/ann", 1);
    EXPECT_EQ(recovery_folder(), "/home/ann/.local/state/batten/recovery");
    unsetenv("HOME");
    EXPECT_EQ(recovery_folder(), "");
}

}  // namespace
}  // namespace batten::editor
