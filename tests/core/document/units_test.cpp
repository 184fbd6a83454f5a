#include "core/document/units.h"

#include <gtest/gtest.h>

namespace batten::core {
namespace {

TEST(Units, are_made_of_each_other) {
    using enum LengthUnit;
    EXPECT_EQ(converted(1.0, inch, mm), 25.4);
    EXPECT_EQ(converted(25.4, mm, inch), 1.0);
    EXPECT_EQ(converted(1.0, inch, px), 96.0);
    EXPECT_EQ(converted(12.0, px, inch), 0.125);
    EXPECT_EQ(converted(96.0, px, mm), 25.4);
    EXPECT_EQ(converted(127.0, mm, px), 480.0);
    EXPECT_EQ(converted(-0.1, mm, mm), -0.1);
    EXPECT_EQ(converted(0.0, inch, px), 0.0);
}

}  // namespace
}  // namespace batten::core
