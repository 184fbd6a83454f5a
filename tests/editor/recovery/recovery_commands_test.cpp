#include "app/editor/commands/recovery_commands.h"

#include <gtest/gtest.h>

#include <array>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/recovery/journal_reader.h"
#include "app/editor/recovery/journal_writer.h"
#include "app/editor/session.h"
#include "app/editor/state/same_document.h"
#include "app/editor/words/moment_text.h"
#include "app/editor/words/recoverable_name.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

namespace fs = std::filesystem;

class RecoveryCommands : public ::testing::Test {
  protected:
    RecoveryCommands() : wave_(folder_.write("wave.json", sample_text)) {
        leave("first", 100, wave_);
        leave("second", 200, {});
        editor_.change(OfferRecovery{find_recoverable(journals_)});
    }
    void leave(const std::string& title, std::int64_t seconds, const fs::path& file) const {
        core::Document document = core::parse_document(sample_text).value();
        document.title = title;
        JournalWriter(journals_).write({document, {file, core::file_stamp(file), seconds, 3}});
    }

    const EditorState& state() const { return editor_.state(); }
    bool run(const Command& command) { return editor_.run(command); }
    fs::path journal(std::size_t i) const { return state().recoverable.at(i).journal; }

    TemporaryFolder folder_;
    fs::path wave_;
    fs::path journals_ = folder_.path() / "recovery";
    Editor editor_;
};

TEST_F(RecoveryCommands, recover_a_document_that_stays_unsaved) {
    run(ShowRecovery{});
    EXPECT_EQ(state().dialog, Dialog::recovery);
    EXPECT_TRUE(run(Recover{.journal = journal(1)}));
    EXPECT_EQ(state().dialog, Dialog::none);
    EXPECT_EQ(document(editor_).title, "first");
    EXPECT_EQ(state().path, wave_);
    EXPECT_TRUE(state().is_modified());
    EXPECT_FALSE(state().history.can_undo());
    EXPECT_EQ(state().message, (Message{"Recovered wave.json; it is not saved yet", false}));
    EXPECT_EQ(state().recoverable.size(), 1U);
    EXPECT_TRUE(run(Save{}));
    EXPECT_FALSE(state().is_modified());
    EXPECT_EQ(core::load_document(wave_).value().title, "first");
}

TEST_F(RecoveryCommands, ask_about_unsaved_changes_first) {
    run(Open{.path = wave_});
    run(MovePoints{.points = {1}, .offset = {1.0, 0.0}});
    EXPECT_TRUE(run(Recover{.journal = journal(0)}));
    EXPECT_EQ(state().dialog, Dialog::unsaved_changes);
    EXPECT_TRUE(run(AnswerUnsaved{.answer = UnsavedAnswer::discard}));
    EXPECT_EQ(document(editor_).title, "second");
    EXPECT_TRUE(state().path.empty());
    EXPECT_EQ(state().message.text, "Recovered the document; it is not saved yet");
}

TEST_F(RecoveryCommands, refuse_what_is_not_offered) {
    EXPECT_FALSE(run(Recover{.journal = wave_}));
    EXPECT_EQ(state().message.text, "there is no such document to recover");
    EXPECT_FALSE(run(DiscardRecovery{.journal = wave_}));
    EXPECT_TRUE(fs::exists(wave_));
    EXPECT_FALSE(run(LeaveRecovery{}));
}

TEST_F(RecoveryCommands, a_damaged_journal_stays_and_changes_nothing) {
    fs::resize_file(journal(0), 20);
    run(ShowRecovery{});
    EXPECT_FALSE(run(Recover{.journal = journal(0)}));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_EQ(state().message.text, "the journal holds no document");
    EXPECT_EQ(state().recoverable.size(), 2U);
    EXPECT_TRUE(fs::exists(journal(0)));
    EXPECT_EQ(state().dialog, Dialog::recovery);
}

TEST_F(RecoveryCommands, discard_one_after_the_other) {
    run(ShowRecovery{});
    const fs::path first = journal(0);
    EXPECT_TRUE(run(DiscardRecovery{.journal = first}));
    EXPECT_FALSE(fs::exists(first));
    EXPECT_EQ(state().dialog, Dialog::recovery);
    EXPECT_TRUE(run(DiscardRecovery{.journal = journal(0)}));
    EXPECT_EQ(state().dialog, Dialog::welcome) << "no document is open";
    EXPECT_FALSE(run(ShowRecovery{}));
    EXPECT_EQ(state().message.text, "there is no unsaved document to recover");
}

TEST_F(RecoveryCommands, leave_them_for_later) {
    run(Open{.path = wave_});
    run(ShowRecovery{});
    EXPECT_TRUE(run(LeaveRecovery{}));
    EXPECT_EQ(state().dialog, Dialog::none);
    EXPECT_EQ(document(editor_).title, "");
    EXPECT_TRUE(run(ShowRecovery{}));
    editor_ = Editor();
    EXPECT_EQ(find_recoverable(journals_).size(), 2U);
}

TEST_F(RecoveryCommands, a_log_is_replayed_where_the_document_is_offered_and_refused_elsewhere) {
    Editor other;
    other.change(OfferRecovery{state().recoverable});
    run(DiscardRecovery{.journal = journal(0)});
    run(Recover{.journal = journal(0)});
    ASSERT_EQ(editor_.log().size(), 1U) << "what is discarded changes no document";
    const std::string line = format_command(editor_.log().front());
    EXPECT_EQ(parse_command(line, Editor().state()).error(), "there is no unsaved document to recover");
    const Outcome<Command> again = parse_command(line, other.state());
    ASSERT_TRUE(again) << again.error();
    EXPECT_TRUE(other.run(*again));
    EXPECT_TRUE(is_same_document(document(other), document(editor_)));
}

class ChangedFile : public ::testing::Test {
  protected:
    ChangedFile() : wave_(folder_.write("wave.json", sample_text)) {
        run(Open{.path = wave_});
        run(RenameCurve{.index = 0, .name = "mine"});
    }
    bool run(const Command& command) { return editor_.run(command); }
    const EditorState& state() const { return editor_.state(); }
    std::string name_on_disk() const { return core::load_document(wave_).value().curves.at(0).name; }

    TemporaryFolder folder_;
    fs::path wave_;
    Editor editor_;
};

TEST_F(ChangedFile, is_not_overwritten_without_a_question) {
    folder_.write("wave.json", bezier_text);
    EXPECT_TRUE(run(Save{}));
    EXPECT_EQ(state().dialog, Dialog::changed_file);
    EXPECT_TRUE(state().is_modified());
    EXPECT_EQ(name_on_disk(), "arch");
    EXPECT_TRUE(run(AnswerChanged{.answer = ChangedAnswer::cancel}));
    EXPECT_EQ(state().dialog, Dialog::none);
    EXPECT_TRUE(state().is_modified());
    EXPECT_EQ(name_on_disk(), "arch");
    run(Save{});
    EXPECT_TRUE(run(AnswerChanged{.answer = ChangedAnswer::overwrite}));
    EXPECT_FALSE(state().is_modified());
    EXPECT_EQ(name_on_disk(), "mine");
    run(RenameCurve{.index = 0, .name = "again"});
    EXPECT_TRUE(run(Save{})) << "what this program wrote is no change";
    EXPECT_EQ(state().dialog, Dialog::none);
    EXPECT_EQ(name_on_disk(), "again");
}

TEST_F(ChangedFile, can_be_left_for_another) {
    folder_.write("wave.json", bezier_text);
    run(Save{});
    EXPECT_TRUE(run(AnswerChanged{.answer = ChangedAnswer::save_as}));
    EXPECT_EQ(state().dialog, Dialog::save_file);
    EXPECT_TRUE(run(SaveAs{.path = folder_.path() / "other.json"}));
    EXPECT_EQ(name_on_disk(), "arch");
    EXPECT_FALSE(state().is_modified());
    EXPECT_FALSE(run(AnswerChanged{.answer = ChangedAnswer::overwrite})) << "nothing is asked";
}

TEST_F(ChangedFile, that_is_gone_is_asked_about_too) {
    fs::remove(wave_);
    EXPECT_TRUE(run(Save{}));
    EXPECT_EQ(state().dialog, Dialog::changed_file);
    EXPECT_FALSE(fs::exists(wave_));
    EXPECT_TRUE(run(AnswerChanged{.answer = ChangedAnswer::overwrite}));
    EXPECT_EQ(name_on_disk(), "mine");
}

TEST_F(ChangedFile, in_a_folder_that_is_gone_is_told) {
    fs::remove_all(folder_.path());
    EXPECT_FALSE(run(Save{}));
    EXPECT_EQ(state().dialog, Dialog::none);
    EXPECT_EQ(state().message.text, "wave.json: there is no folder " + folder_.path().string());
    EXPECT_TRUE(state().is_modified());
    EXPECT_EQ(document(editor_).curves[0].name, "mine");
}

TEST_F(ChangedFile, keeps_what_waits_for_saving) {
    folder_.write("wave.json", bezier_text);
    run(Quit{});
    run(AnswerUnsaved{.answer = UnsavedAnswer::save});
    EXPECT_EQ(state().dialog, Dialog::changed_file);
    EXPECT_FALSE(state().wants_quit);
    EXPECT_TRUE(run(AnswerChanged{.answer = ChangedAnswer::overwrite}));
    EXPECT_TRUE(state().wants_quit);
    EXPECT_EQ(name_on_disk(), "mine");
}

TEST(MomentText, says_when_as_people_do) {
    setenv("TZ", "UTC", 1);
    tzset();
    constexpr std::int64_t now = 1'795'447'440;  // November 23, 2026, 15:24
    constexpr std::int64_t day = 86'400;
    EXPECT_EQ(moment_text(now, now), "today at 15:24");
    EXPECT_EQ(moment_text(now - 15 * 3600 - 19 * 60, now), "today at 0:05");
    EXPECT_EQ(moment_text(now - 16 * 3600, now), "yesterday at 23:24");
    EXPECT_EQ(moment_text(now - day, now), "yesterday at 15:24");
    EXPECT_EQ(moment_text(now - 2 * day, now), "on November 21, 2026 at 15:24");
    EXPECT_EQ(moment_text(0, now), "on January 1, 1970 at 0:00");
}

TEST(RecoverableName, tells_files_of_one_name_apart_by_their_folders) {
    std::vector<Recoverable> all(5);
    for (std::size_t i = 0; i < 4; ++i)
        all[i].file = std::array{"/a/wave.json", "/b/wave.json", "/a/ring.json", "/a/ring.json"}[i];
    const std::vector<std::string> names{"a/wave.json", "b/wave.json", "ring.json", "ring.json", "untitled"};
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(recoverable_name(all[i], all), names[i]);
    EXPECT_EQ(recoverable_name(all[0], {}), "wave.json");
}

}  // namespace
}  // namespace batten::editor
