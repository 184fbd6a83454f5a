#include "app/ui/curve_rows.h"

#include <gtest/gtest.h>

namespace batten::ui {
namespace {

core::Document document_with(const std::vector<std::string>& groups) {
    core::Document document;
    for (const std::string& group : groups) {
        core::DocumentCurve entry;
        entry.group = group;
        document.curves.push_back(entry);
    }
    return document;
}

using Rows = std::vector<CurveRow>;

TEST(CurveRows, curves_without_groups_are_their_rows) {
    EXPECT_EQ(curve_rows(document_with({"", "", ""}), {}), (Rows{{0}, {1}, {2}}));
    EXPECT_TRUE(curve_rows({}, {}).empty());
}

TEST(CurveRows, members_follow_their_heading_wherever_they_are) {
    const core::Document document = document_with({"", "a", "b", "", "a", "b"});
    EXPECT_EQ(
        curve_rows(document, {}),
        (Rows{{0}, {1, true}, {1, false, true}, {4, false, true}, {2, true}, {2, false, true}, {5, false, true}, {3}}));
    EXPECT_EQ(curve_rows(document, {"a", "c"}),
              (Rows{{0}, {1, true}, {2, true}, {2, false, true}, {5, false, true}, {3}}));
}

TEST(CurveRows, are_taken_from_one_to_another) {
    using Indices = std::vector<std::size_t>;
    const core::Document document = document_with({"", "a", "b", "", "a", "b"});
    const Rows all = curve_rows(document, {});
    EXPECT_EQ(curves_between(all, 0, 4), (Indices{0, 1, 4}));
    EXPECT_EQ(curves_between(all, 3, 4), (Indices{4, 2, 5, 3}));
    EXPECT_EQ(curves_between(all, 2, 2), (Indices{2}));
    EXPECT_EQ(curves_between(curve_rows(document, {"a"}), 4, 2), (Indices{2})) << "its group is folded";
    EXPECT_EQ(curves_between(all, 9, 2), (Indices{2})) << "it was deleted";
}

struct Drop {
    std::size_t from;
    std::size_t slot;
    std::size_t to;
    std::optional<std::string> group{};
};

TEST(CurveRows, a_dropped_curve_stands_before_the_row_below_it) {
    const core::Document document = document_with({"", "", "a", "a", ""});
    // 0, 1, heading of a, 2, 3, 4
    const Rows rows = curve_rows(document, {});
    ASSERT_EQ(rows.size(), 6U);
    for (const Drop& drop : {Drop{0, 2, 1}, Drop{1, 0, 0}, Drop{0, 6, 4}, Drop{0, 5, 3}, Drop{4, 0, 0},
                             Drop{0, 3, 1, "a"}, Drop{0, 4, 2, "a"}, Drop{4, 4, 3, "a"}, Drop{2, 5, 3}, Drop{3, 3, 2},
                             Drop{2, 6, 4, ""}, Drop{3, 0, 0, ""}, Drop{2, 2, 2, ""}}) {
        const auto command = dropped_curve(document, rows, drop.from, drop.slot);
        ASSERT_TRUE(command.has_value()) << drop.from << " before row " << drop.slot;
        EXPECT_EQ(command->from, drop.from);
        EXPECT_EQ(command->to, drop.to) << drop.from << " before row " << drop.slot;
        EXPECT_EQ(command->group, drop.group) << drop.from << " before row " << drop.slot;
    }
    for (const Drop& stays : {Drop{0, 0, 0}, Drop{0, 1, 0}, Drop{1, 2, 0}, Drop{2, 3, 0}, Drop{2, 4, 0}, Drop{3, 5, 0},
                              Drop{4, 6, 0}, Drop{4, 5, 0}})
        EXPECT_FALSE(dropped_curve(document, rows, stays.from, stays.slot).has_value())
            << stays.from << " before row " << stays.slot;
}

TEST(CurveRows, a_dropped_group_stands_before_the_row_below_it) {
    const core::Document document = document_with({"", "a", "b", "", "a", "b"});
    // 0, heading of a, 1, 4, heading of b, 2, 5, 3
    const Rows rows = curve_rows(document, {});
    ASSERT_EQ(rows.size(), 8U);
    const auto dropped = [&](std::size_t row, std::size_t slot) {
        return dropped_group(document, rows, rows[row], slot);
    };
    ASSERT_TRUE(dropped(4, 0));
    EXPECT_EQ(dropped(4, 0)->group, "b");
    EXPECT_EQ(dropped(4, 0)->before, 0U);
    EXPECT_EQ(dropped(4, 1)->before, 1U);
    EXPECT_EQ(dropped(1, 7)->group, "a");
    EXPECT_EQ(dropped(1, 7)->before, 3U);
    EXPECT_EQ(dropped(1, 8)->before, std::nullopt);
    for (const std::size_t slot : std::vector<std::size_t>{1, 2, 3, 4}) EXPECT_FALSE(dropped(1, slot)) << slot;
    for (const std::size_t slot : std::vector<std::size_t>{4, 5, 6, 7}) EXPECT_FALSE(dropped(4, slot)) << slot;
    for (const std::size_t slot : std::vector<std::size_t>{0, 1, 4, 7, 8})
        EXPECT_TRUE(can_be_dropped(rows, rows[1], slot)) << slot;
    for (const std::size_t slot : std::vector<std::size_t>{2, 3, 5, 6}) {
        EXPECT_FALSE(can_be_dropped(rows, rows[1], slot)) << slot;
        EXPECT_TRUE(can_be_dropped(rows, rows[0], slot)) << slot;
    }
}

}  // namespace
}  // namespace batten::ui
