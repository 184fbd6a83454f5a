#include "core/base/exact_number.h"

#include <gtest/gtest.h>

#include <limits>

namespace batten::core {

namespace {

constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();

ExactNumber exact(std::int64_t numerator, std::int64_t denominator = 1) {
    return Fraction{numerator, denominator};
}

}  // namespace

TEST(ExactNumber, computes_in_lowest_terms) {
    EXPECT_EQ(exact(1, 6) + exact(1, 10), exact(4, 15));
    EXPECT_EQ(exact(1, 6) - exact(1, 10), exact(1, 15));
    EXPECT_EQ(exact(1, 10) - exact(1, 6), exact(-1, 15));
    EXPECT_EQ(exact(1, 6) - exact(2, 12), exact(0));
    EXPECT_EQ(exact(-4, 9) * exact(3, 8), exact(-1, 6));
    EXPECT_EQ(exact(4, 9) / exact(-8, 3), exact(-1, 6));
    EXPECT_EQ(exact(0) / exact(-7, 3), exact(0));
}

TEST(ExactNumber, is_none_where_a_part_leaves_64_bits) {
    EXPECT_EQ(exact(most) + exact(1), std::nullopt);
    EXPECT_EQ(exact(-most) - exact(1), std::nullopt);
    EXPECT_EQ(exact(1LL << 32) * exact(1LL << 31), std::nullopt);
    EXPECT_EQ(exact(1, 3037000500) * exact(1, 3037000500), std::nullopt);
    EXPECT_EQ(exact(1, most) + exact(1, most - 1), std::nullopt);
}

TEST(ExactNumber, reaches_the_ends_of_64_bits) {
    EXPECT_EQ(exact(most - 1) + exact(1), exact(most));
    EXPECT_EQ(exact(most, 3) * exact(3, most), exact(1));
    EXPECT_EQ(exact(1, most) - exact(2, most), exact(-1, most));
}

TEST(ExactNumber, stays_none) {
    const ExactNumber none = exact(1) / exact(0);
    EXPECT_EQ(none, std::nullopt);
    EXPECT_EQ(none + exact(1), std::nullopt);
    EXPECT_EQ(exact(1) - none, std::nullopt);
    EXPECT_EQ(none * exact(0), std::nullopt);
    EXPECT_EQ(exact(1) / none, std::nullopt);
    EXPECT_EQ(none / exact(1), std::nullopt);
}

}  // namespace batten::core
