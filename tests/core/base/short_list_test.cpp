#include "core/base/detail/short_list.h"

#include <gtest/gtest.h>

namespace batten::core {

TEST(ShortList, is_like_a_vector_at_any_length) {
    std::vector<int> expected;
    ShortList<int, 3> list;
    EXPECT_TRUE(list.empty());
    for (int i = 0; i < 10; ++i) {
        list.push_back(7 * i);
        expected.push_back(7 * i);
        EXPECT_EQ(list.size(), expected.size());
        EXPECT_EQ(std::vector<int>(list), expected);
        EXPECT_EQ(list.back(), 7 * i);
        EXPECT_EQ((ShortList<int, 3>(expected)), list);
        const ShortList<int, 3> copy = list;
        EXPECT_EQ(copy, list);
        ShortList<int, 3> assigned{1, 2, 3, 4, 5};
        assigned.assign(expected);
        EXPECT_EQ(assigned, list);
        list[0] = 5;
        EXPECT_NE(copy, list);
        list[0] = 0;
    }
    EXPECT_EQ((ShortList<int, 3>{0, 7}), (ShortList<int, 3>(std::span(expected).first(2))));
    EXPECT_NE((ShortList<int, 3>{0, 7}), (ShortList<int, 3>{0, 7, 14}));
    for (const std::size_t count : {0u, 1u, 2u, 5u}) {
        const ShortList<std::vector<int>, 2> empty(count);
        EXPECT_EQ(empty.size(), count);
        for (const std::vector<int>& item : empty) EXPECT_TRUE(item.empty());
    }
}

}  // namespace batten::core
