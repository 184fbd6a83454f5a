// Journals on disks that fail, and between sessions.

#include <gtest/gtest.h>

#include <cerrno>
#include <fstream>
#include <set>
#include <thread>

#include "app/editor/recovery/held_journal.h"
#include "app/editor/recovery/journal_reader.h"
#include "app/editor/recovery/journal_writer.h"
#include "app/editor/state/same_document.h"
#include "tests/disk/failing_disk.h"
#include "tests/disk/small_disk.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

namespace fs = std::filesystem;

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(HeldJournal, is_replaced_and_appended) {
    const TemporaryFolder folder;
    HeldJournal journal(folder.path() / "new folder" / "1.journal");
    EXPECT_FALSE(journal.is_there());
    ASSERT_TRUE(journal.replace("first"));
    EXPECT_TRUE(journal.is_there());
    ASSERT_TRUE(journal.append(", second"));
    EXPECT_EQ(journal.content().value(), "first, second");
    ASSERT_TRUE(journal.replace("anew"));
    ASSERT_TRUE(journal.append("!"));
    EXPECT_EQ(journal.content().value(), "anew!");
    EXPECT_EQ(files_in(folder.path() / "new folder"), 1U);
    journal.remove();
    EXPECT_FALSE(journal.is_there());
    EXPECT_EQ(files_in(folder.path() / "new folder"), 0U);
}

TEST(HeldJournal, belongs_to_one_session_at_a_time) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "1.journal";
    EXPECT_EQ(HeldJournal::take(path), nullptr);
    {
        HeldJournal first(path);
        ASSERT_TRUE(first.replace("text"));
        EXPECT_EQ(HeldJournal::take(path), nullptr);
        ASSERT_TRUE(first.replace("other"));
        EXPECT_EQ(HeldJournal::take(path), nullptr);
    }
    const auto second = HeldJournal::take(path);
    ASSERT_NE(second, nullptr);
    EXPECT_EQ(second->content().value(), "other");
    EXPECT_EQ(HeldJournal::take(path), nullptr);
    ASSERT_TRUE(second->append(" end"));
    EXPECT_EQ(second->content().value(), "other end");
    fs::create_directory(folder.path() / "2.journal");
    EXPECT_EQ(HeldJournal::take(folder.path() / "2.journal"), nullptr);
}

TEST(HeldJournal, keeps_what_it_had_on_a_disk_that_fails_at_any_call) {
    const TemporaryFolder folder;
    HeldJournal journal(folder.path() / "1.journal");
    std::set<std::string> failed;
    for (int nth = 0;; ++nth) {
        ASSERT_TRUE(journal.replace("old"));
        Outcome<void> replaced;
        {
            const test::FailingDisk disk(nth, ENOSPC);
            replaced = journal.replace("new content");
        }
        failed.insert(test::FailingDisk::failed());
        EXPECT_EQ(journal.content().value(), replaced ? "new content" : "old");
        EXPECT_EQ(files_in(folder.path()), 1U);
        {
            const test::FailingDisk disk(nth, EIO);
            replaced = journal.append(" and more");
        }
        failed.insert(test::FailingDisk::failed());
        ASSERT_TRUE(journal.append("!"));
        const std::string content = journal.content().value();
        EXPECT_TRUE(content.ends_with(replaced ? " and more!" : "!"));
        EXPECT_EQ(content.find("and") != std::string::npos, replaced.has_value());
        if (test::FailingDisk::failed().empty() && nth > 20) break;
    }
    for (const char* call : {"open", "pwrite", "fdatasync", "rename"}) EXPECT_TRUE(failed.contains(call)) << call;
}

// The document as the reader finds it in the one journal of the folder.
core::Document found_in(const fs::path& folder) {
    const std::vector<Recoverable> found = find_recoverable(folder);
    EXPECT_EQ(found.size(), 1U);
    return document_of_journal(*found.at(0).held).value();
}

core::Document titled_sample(std::size_t number) {
    core::Document document = core::parse_document(sample_text).value();
    document.title = "number " + std::to_string(number);
    return document;
}

TEST(JournalWriter, goes_on_on_a_disk_that_fails_and_tells_so_once) {
    for (int nth = 0; nth < 12; ++nth) {
        const TemporaryFolder folder;
        std::size_t told = 0;
        {
            JournalWriter writer(folder.path(), {}, std::chrono::milliseconds(0));
            for (std::size_t i = 0; i < 4; ++i) {
                const test::FailingDisk disk(nth, ENOSPC);
                writer.write({titled_sample(i), {}});
                writer.finish();
                if (const auto trouble = writer.take_trouble()) {
                    ++told;
                    EXPECT_EQ(
                        *trouble,
                        "Unsaved changes would be lost in a crash, because no recovery journal can be written: No "
                        "space left on device");
                }
            }
            writer.write({titled_sample(9), {}});
        }
        EXPECT_TRUE(is_same_document(found_in(folder.path()), titled_sample(9))) << nth;
        // The first of the four makes the file by four calls; what comes after them may fail without loss.
        EXPECT_EQ(told, nth < 4 ? 1U : 0U) << nth;
    }
}

TEST(JournalWriter, begins_anew_where_its_file_was_removed) {
    const TemporaryFolder folder;
    {
        JournalWriter writer(folder.path() / "recovery", {}, std::chrono::milliseconds(0));
        writer.write({titled_sample(1), {}});
        writer.finish();
        fs::remove_all(folder.path() / "recovery");
        writer.write({titled_sample(2), {}});
    }
    EXPECT_TRUE(is_same_document(found_in(folder.path() / "recovery"), titled_sample(2)));
}

TEST(JournalWriter, does_not_grow_without_end) {
    const TemporaryFolder folder;
    std::uintmax_t most = 0;
    {
        JournalWriter writer(folder.path(), {}, std::chrono::milliseconds(0));
        for (std::size_t i = 0; i < 1200; ++i) {
            writer.write({titled_sample(i), {}});
            writer.finish();
            for (const auto& entry : fs::directory_iterator(folder.path())) most = std::max(most, entry.file_size());
        }
    }
    EXPECT_LT(most, 100'000U);
    EXPECT_TRUE(is_same_document(found_in(folder.path()), titled_sample(1199)));
}

TEST(JournalWriter, tells_of_a_full_disk_and_of_a_folder_that_cannot_be) {
    const TemporaryFolder folder;
    folder.write("file", "");
    JournalWriter nowhere(folder.path() / "file" / "recovery");
    nowhere.write({titled_sample(1), {}});
    nowhere.finish();
    EXPECT_TRUE(nowhere.take_trouble());
    EXPECT_FALSE(nowhere.take_trouble());
    nowhere.clear();
    nowhere.finish();
}

TEST(JournalWriter, keeps_the_last_document_that_fitted_on_a_full_disk) {
    const TemporaryFolder folder;
    // This thread alone sees the disk, and those that it starts.
    if (!test::mount_small_disk(folder.path(), 64)) GTEST_SKIP() << "mounting a small disk is not permitted here";
    core::Document large = titled_sample(2);
    large.description.assign(100'000, 'x');
    {
        JournalWriter writer(folder.path(), {}, std::chrono::milliseconds(0));
        writer.write({titled_sample(1), {}});
        writer.finish();
        writer.write({large, {}});
        writer.finish();
        EXPECT_TRUE(writer.take_trouble());
    }
    EXPECT_TRUE(is_same_document(found_in(folder.path()), titled_sample(1)));
    umount(folder.path().c_str());
}

TEST(JournalWriter, tries_again_what_came_to_nothing) {
    const TemporaryFolder folder;
    {
        JournalWriter writer(folder.path(), {}, std::chrono::milliseconds(0));
        const test::FailingDisk disk(0, ENOSPC);
        writer.write({titled_sample(1), {}});
        while (!writer.take_trouble()) std::this_thread::yield();
    }
    EXPECT_EQ(found_in(folder.path()).title, "number 1");
}

TEST(JournalWriter, keeps_its_journal_until_the_recovered_one_has_the_document) {
    for (int nth = 0; nth < 12; ++nth) {
        const TemporaryFolder own;
        const TemporaryFolder recovered;
        {
            const auto held = std::make_shared<HeldJournal>(recovered.path() / "1.journal");
            ASSERT_TRUE(held->replace("of a session before"));
            JournalWriter writer(own.path(), {}, std::chrono::milliseconds(0));
            writer.write({titled_sample(0), {}});
            writer.finish();
            {
                const test::FailingDisk disk(nth, ENOSPC);
                writer.write({titled_sample(1), {}, held});
                writer.finish();
            }
            EXPECT_EQ(files_in(own.path()) + files_in(recovered.path()), held->content().value()[0] == 'o' ? 2U : 1U);
            for (const std::size_t i : {2U, 3U}) {
                writer.write({titled_sample(i), {}, held});
                writer.finish();
            }
        }
        EXPECT_EQ(files_in(own.path()), 0U) << nth;
        EXPECT_EQ(found_in(recovered.path()).title, "number 3") << nth;
    }
}

TEST(JournalWriter, removes_a_recovered_journal_that_is_given_up_while_it_waits) {
    const TemporaryFolder own;
    const TemporaryFolder recovered;
    const auto held = std::make_shared<HeldJournal>(recovered.path() / "1.journal");
    ASSERT_TRUE(held->replace("of a session before"));
    JournalWriter writer(own.path(), {}, std::chrono::hours(1));
    writer.write({titled_sample(0), {}});
    while (files_in(own.path()) == 0) std::this_thread::yield();
    // The disk has peace now, so that these wait.
    writer.write({titled_sample(1), {}, held});
    writer.clear();
    writer.finish();
    EXPECT_EQ(files_in(own.path()), 0U);
    EXPECT_EQ(files_in(recovered.path()), 0U);
}

}  // namespace
}  // namespace batten::editor
