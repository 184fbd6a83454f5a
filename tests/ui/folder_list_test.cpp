#include "app/ui/folder_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "temporary_folder.h"

namespace batten::ui {
namespace {

std::vector<std::string> names_of(const FolderContent& content) {
    std::vector<std::string> names;
    for (const FolderEntry& entry : content.entries) names.push_back(entry.is_folder ? entry.name + "/" : entry.name);
    return names;
}

TEST(FolderList, numbers_count_as_numbers) {
    const std::vector<std::string> expected{"",     "0",      "a",       "A1",    "a2",     "a02b",
                                            "a10",  "a10a",   "a10b1",   "a10b9", "a10b10", "b",
                                            "wave", "Wave 2", "wave 10", "waves", "ä"};
    for (std::size_t i = 0; i < expected.size(); ++i)
        for (std::size_t j = 0; j < expected.size(); ++j)
            EXPECT_EQ(comes_before(expected[i], expected[j]), i < j) << expected[i] << " and " << expected[j];
    EXPECT_TRUE(comes_before("7", "99999999999999999999998"));
    EXPECT_TRUE(comes_before("99999999999999999999998", "99999999999999999999999"));
}

TEST(FolderList, equal_numbers_and_letters_have_an_order_all_the_same) {
    EXPECT_NE(comes_before("a1", "a01"), comes_before("a01", "a1"));
    EXPECT_NE(comes_before("wave", "Wave"), comes_before("Wave", "wave"));
    EXPECT_FALSE(comes_before("wave", "wave"));
}

TEST(FolderList, folders_come_first_and_2_before_10) {
    const TemporaryFolder folder;
    for (const char* name : {"wave 10.json", "Wave 2.json", "wave.json", "notes.txt", ".hidden.json", "arch.JSON"})
        folder.add_file(name);
    for (const char* name : {"week 10", "Week 9", ".git"}) folder.add_folder(name);
    const FolderContent content = read_folder(folder.path());
    EXPECT_EQ(names_of(content), (std::vector<std::string>{"Week 9/", "week 10/", "arch.JSON", "wave.json",
                                                           "Wave 2.json", "wave 10.json"}));
    EXPECT_EQ(content.problem, "");
}

TEST(FolderList, what_cannot_be_read_is_a_sentence) {
    const FolderContent content = read_folder("/no/such folder");
    EXPECT_EQ(content.problem, "there is no folder /no/such folder");
    EXPECT_TRUE(content.is_missing);
    EXPECT_TRUE(content.entries.empty());
    const TemporaryFolder folder;
    folder.add_file("wave.json");
    const FolderContent file = read_folder(folder.path() / "wave.json");
    EXPECT_TRUE(file.problem.ends_with("wave.json cannot be read: Not a directory")) << file.problem;
    EXPECT_FALSE(file.is_missing);
}

TEST(FolderList, text_is_found_in_any_case) {
    const std::vector<FolderEntry> entries{{"Wave.json"}, {"arch.json"}, {"microwave.json"}};
    EXPECT_EQ(entries_with(entries, "wAvE"), (std::vector<std::size_t>{0, 2}));
    EXPECT_EQ(entries_with(entries, ""), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(entries_with(entries, "x"), std::vector<std::size_t>{});
}

TEST(FolderList, ten_thousand_files_are_quick) {
    const TemporaryFolder folder;
    for (int i = 0; i < 10000; ++i) folder.add_file("curve " + std::to_string(i) + ".json");
    const auto begin = std::chrono::steady_clock::now();
    const FolderContent content = read_folder(folder.path());
    const std::vector<std::size_t> found = entries_with(content.entries, "99");
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    ASSERT_EQ(content.entries.size(), 10000U);
    for (std::size_t i = 0; i < 10000; ++i) EXPECT_EQ(content.entries[i].name, "curve " + std::to_string(i) + ".json");
    // 99, 199, ..., 9999 with 990 ... 999 and 9900 ... 9999 and those with 99 in their middle.
    const auto has_99 = [](std::size_t i) { return std::to_string(i).find("99") != std::string::npos; };
    for (const std::size_t i : found) EXPECT_TRUE(has_99(i));
    EXPECT_EQ(found.size(), 280U);
    RecordProperty("milliseconds", static_cast<int>(1e3 * taken.count()));
    EXPECT_LT(taken.count(), 5.0);
}

}  // namespace
}  // namespace batten::ui
