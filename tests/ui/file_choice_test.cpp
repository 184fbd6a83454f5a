#include "app/ui/file_choice.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "temporary_folder.h"

namespace batten::ui {
namespace {

// A folder with wave.json, wave 2.json, arch.json and the folder week with notes.json.
class FileChoices : public testing::Test {
  protected:
    FileChoices() {
        for (const char* name : {"wave.json", "wave 2.json", "arch.json"}) folder_.add_file(name);
        folder_.add_folder("week");
        folder_.add_file("week/notes.json");
        EXPECT_EQ(enter_folder(choice_, folder_.path(), ""), "");
    }

    void type(const std::string& text, bool chooses_best = true) {
        choice_.typed = text;
        follow_typed(choice_, chooses_best);
    }

    std::vector<std::string> shown() const {
        std::vector<std::string> names;
        for (const std::size_t i : choice_.shown) names.push_back(choice_.listed.entries[i].name);
        return names;
    }

    TemporaryFolder folder_;
    FileChoice choice_;
};

TEST_F(FileChoices, all_is_shown_until_something_is_typed) {
    EXPECT_EQ(shown(), (std::vector<std::string>{"week", "arch.json", "wave.json", "wave 2.json"}));
    EXPECT_EQ(choice_.chosen, std::nullopt);
    EXPECT_EQ(chosen_path(choice_), std::nullopt);
}

TEST_F(FileChoices, typing_filters_and_chooses) {
    type("AV");
    EXPECT_EQ(shown(), (std::vector<std::string>{"wave.json", "wave 2.json"}));
    EXPECT_EQ(chosen_path(choice_), folder_.path() / "wave.json");
    EXPECT_EQ(choice_.typed, "AV");
    type("wave 2");
    EXPECT_EQ(chosen_path(choice_), folder_.path() / "wave 2.json");
    type("wavelet");
    EXPECT_TRUE(shown().empty());
    EXPECT_EQ(choice_.chosen, std::nullopt);
    type("");
    EXPECT_EQ(shown().size(), 4U);
}

TEST_F(FileChoices, the_file_of_that_name_is_chosen_before_others) {
    folder_.add_file("a wave.json");
    enter_folder(choice_, folder_.path(), "");
    type("wave");
    EXPECT_EQ(shown().front(), "a wave.json");
    EXPECT_EQ(chosen_path(choice_), folder_.path() / "wave.json");
}

TEST_F(FileChoices, saving_chooses_nothing_by_typing) {
    type("wave", false);
    EXPECT_EQ(shown(), (std::vector<std::string>{"wave.json", "wave 2.json"}));
    EXPECT_EQ(choice_.chosen, std::nullopt);
}

TEST_F(FileChoices, keys_move_among_what_fits) {
    type("wave", false);
    move_choice(choice_, 1);
    EXPECT_EQ(choice_.typed, "wave.json");
    move_choice(choice_, 1);
    EXPECT_EQ(choice_.typed, "wave 2.json");
    EXPECT_EQ(shown().size(), 2U) << "the list stays while keys move in it";
    move_choice(choice_, 10);
    EXPECT_EQ(choice_.chosen, 1U);
    move_choice(choice_, -10);
    EXPECT_EQ(choice_.chosen, 0U);
    EXPECT_TRUE(choice_.is_led_by_keys);
    type("arch");
    EXPECT_FALSE(choice_.is_led_by_keys);
}

TEST_F(FileChoices, moving_up_begins_at_the_end) {
    move_choice(choice_, -1);
    EXPECT_EQ(choice_.typed, "wave 2.json");
    FileChoice nothing;
    move_choice(nothing, 1);
    EXPECT_EQ(nothing.chosen, std::nullopt);
}

TEST_F(FileChoices, a_typed_folder_is_listed) {
    type("week/no");
    EXPECT_EQ(shown(), std::vector<std::string>{"notes.json"});
    EXPECT_EQ(choice_.listed.folder, folder_.path() / "week");
    move_choice(choice_, 1);
    EXPECT_EQ(choice_.typed, "week/notes.json");
    EXPECT_EQ(meant_path(choice_.folder, choice_.typed), folder_.path() / "week" / "notes.json");
    type("wa");
    EXPECT_EQ(choice_.listed.folder, folder_.path());
    type((folder_.path() / "week").string() + "/");
    EXPECT_EQ(shown(), std::vector<std::string>{"notes.json"});
    type("nowhere/");
    EXPECT_NE(choice_.listed.problem.find("there is no folder"), std::string::npos);
    EXPECT_TRUE(shown().empty());
}

TEST_F(FileChoices, tilde_is_the_home_folder) {
    const char* old = std::getenv("HOME");
    const std::string before = old == nullptr ? "" : old;
    setenv("HOME", folder_.path().c_str(), 1);
    EXPECT_EQ(meant_path("/elsewhere", "~"), folder_.path());
    EXPECT_EQ(meant_path("/elsewhere", "~/week/x.json"), folder_.path() / "week/x.json");
    EXPECT_EQ(meant_path("/elsewhere", "~wave.json"), "/elsewhere/~wave.json");
    ASSERT_EQ(enter_folder(choice_, "/", ""), "");
    for (const char* home : {"~", "~/"}) {
        type(home);
        EXPECT_EQ(choice_.listed.folder, folder_.path());
        ASSERT_EQ(shown().size(), 4U);
        choose(choice_, 1);
        EXPECT_EQ(choice_.typed, "~/arch.json");
    }
    setenv("HOME", before.c_str(), 1);
}

TEST_F(FileChoices, a_folder_that_cannot_be_read_changes_nothing) {
    type("wave");
    EXPECT_NE(enter_folder(choice_, "/no/such", ""), "");
    EXPECT_EQ(choice_.folder, folder_.path());
    EXPECT_EQ(choice_.typed, "wave");
}

}  // namespace
}  // namespace batten::ui
