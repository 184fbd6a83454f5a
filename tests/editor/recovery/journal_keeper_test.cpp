#include "app/editor/recovery/journal_keeper.h"

#include <gtest/gtest.h>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/recovery/journal_reader.h"
#include "app/editor/state/same_document.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

namespace fs = std::filesystem;

class Keeper : public ::testing::Test {
  protected:
    Keeper() : wave_(folder_.write("wave.json", sample_text)) { run(Open{.path = wave_}); }
    ~Keeper() override { keeper_.reset(); }

    bool run(const Command& command) {
        const bool is_done = editor_.run(command);
        keeper_->follow(editor_.state(), ++seconds_);
        return is_done;
    }
    bool move(double distance) { return run(MovePoints{.points = {1}, .offset = {distance, 0.0}}); }

    // What the next session would find if this one ended now.
    std::vector<Recoverable> left_behind() {
        keeper_->finish();
        keeper_ = nullptr;  // the lock ends with it
        return find_recoverable(journals_);
    }
    std::size_t journal_count() {
        keeper_->finish();
        std::error_code error;
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(journals_, error), fs::directory_iterator()));
    }

    TemporaryFolder folder_;
    fs::path wave_;
    fs::path journals_ = folder_.path() / "state" / "recovery";
    Editor editor_;
    std::unique_ptr<JournalKeeper> keeper_ = std::make_unique<JournalKeeper>(journals_);
    std::int64_t seconds_ = 1'000;
};

TEST_F(Keeper, writes_nothing_while_nothing_is_unsaved) {
    EXPECT_EQ(journal_count(), 0U);
    EXPECT_FALSE(fs::exists(journals_));
    keeper_->end();
    EXPECT_EQ(journal_count(), 0U);
}

TEST_F(Keeper, has_the_last_committed_document) {
    move(0.5);
    move(-2.0);
    editor_.run(MovePoints{.points = {2}, .offset = {9.0, 0.0}}, Phase::preview);
    keeper_->follow(editor_.state(), 5'000);
    const auto left = left_behind();
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].file, wave_);
    EXPECT_EQ(left[0].stamp, core::file_stamp(wave_));
    EXPECT_EQ(left[0].seconds, 1'003);
    EXPECT_EQ(left[0].edit_count, 2U);
    EXPECT_TRUE(is_same_document(document_of_journal(*left[0].held).value(), document(editor_)));
}

TEST_F(Keeper, begins_anew_where_another_program_cut_the_journal_off) {
    move(0.5);
    keeper_->finish();
    for (const auto& entry : fs::directory_iterator(journals_)) fs::resize_file(entry.path(), 0);
    move(1.0);
    const auto left = left_behind();
    ASSERT_EQ(left.size(), 1U);
    EXPECT_TRUE(is_same_document(document_of_journal(*left[0].held).value(), document(editor_)));
}

TEST_F(Keeper, follows_undo_and_redo) {
    move(0.5);
    const core::Document once = document(editor_);
    move(1.0);
    run(Undo{});
    auto left = left_behind();
    ASSERT_EQ(left.size(), 1U);
    EXPECT_TRUE(is_same_document(document_of_journal(*left[0].held).value(), once));
    EXPECT_EQ(left[0].edit_count, 3U);
}

TEST_F(Keeper, removes_the_journal_of_what_is_saved_or_undone) {
    move(0.5);
    EXPECT_EQ(journal_count(), 1U);
    run(Undo{});
    EXPECT_EQ(journal_count(), 0U);
    run(Redo{});
    EXPECT_EQ(journal_count(), 1U);
    run(Save{});
    EXPECT_EQ(journal_count(), 0U);
    move(0.25);
    const auto left = left_behind();
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].edit_count, 1U);
    EXPECT_EQ(left[0].stamp, core::file_stamp(wave_));
}

TEST_F(Keeper, removes_the_journal_at_a_good_end_and_of_discarded_changes) {
    move(0.5);
    run(NewDocument{});
    EXPECT_EQ(journal_count(), 1U);
    run(AnswerUnsaved{.answer = UnsavedAnswer::discard});
    EXPECT_EQ(journal_count(), 0U);
    run(Open{.path = wave_});
    move(0.5);
    EXPECT_EQ(journal_count(), 1U);
    keeper_->end();
    EXPECT_EQ(journal_count(), 0U);
    EXPECT_TRUE(left_behind().empty());
}

TEST_F(Keeper, of_no_folder_keeps_nothing_and_says_so_once) {
    JournalKeeper none("");
    none.follow(editor_.state(), 0);
    EXPECT_FALSE(none.take_trouble()) << "nothing is unsaved";
    move(0.5);
    none.follow(editor_.state(), 1);
    EXPECT_EQ(none.take_trouble(),
              "Unsaved changes would be lost in a crash, because no recovery journal can be written: neither HOME nor "
              "XDG_STATE_HOME names a folder");
    move(0.7);
    none.follow(editor_.state(), 2);
    EXPECT_FALSE(none.take_trouble());
    none.finish();
    none.end();
}

TEST_F(Keeper, of_another_session_has_a_journal_of_its_own) {
    move(0.5);
    keeper_->finish();
    EXPECT_TRUE(find_recoverable(journals_).empty()) << "it is held";
    JournalKeeper other(journals_);
    Editor editor;
    open_text(editor, bezier_text);
    editor.run(MovePoints{.points = {0}, .offset = {1.0, 0.0}});
    other.follow(editor.state(), 7);
    other.finish();
    EXPECT_EQ(journal_count(), 2U);
    keeper_->end();
    EXPECT_EQ(journal_count(), 1U);
}

TEST_F(Keeper, goes_on_with_a_journal_that_was_recovered) {
    move(0.5);
    move(0.5);
    move(0.5);
    auto left = left_behind();
    ASSERT_EQ(left.size(), 1U);
    const core::Document before = document(editor_);
    keeper_ = std::make_unique<JournalKeeper>(journals_);
    editor_ = Editor();
    editor_.change(OfferRecovery{left});
    left.clear();
    run(Recover{.journal = editor_.state().recoverable.at(0).journal});
    EXPECT_TRUE(is_same_document(document(editor_), before));
    EXPECT_EQ(journal_count(), 1U);
    EXPECT_TRUE(find_recoverable(journals_).empty()) << "it is held still";
    move(1.0);
    EXPECT_EQ(journal_count(), 1U);
    const core::Document after = document(editor_);
    editor_ = Editor();
    left = left_behind();
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].edit_count, 4U);
    EXPECT_TRUE(is_same_document(document_of_journal(*left[0].held).value(), after));
}

}  // namespace
}  // namespace batten::editor
