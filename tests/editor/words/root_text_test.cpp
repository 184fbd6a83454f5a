#include "app/editor/words/root_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace batten::editor {
namespace {

TEST(RootText, writes_roots_of_small_fractions) {
    const Notation notation;
    EXPECT_EQ(root_text(notation, std::sqrt(0.5)), "√2/2");
    EXPECT_EQ(root_text(notation, std::sqrt(3.0) / 2.0), "√3/2");
    EXPECT_EQ(root_text(notation, std::sqrt(2.0)), "√2");
    EXPECT_EQ(root_text(notation, std::sqrt(8.0)), "2√2");
    EXPECT_EQ(root_text(notation, 3.0 * std::sqrt(5.0) / 2.0), "3√5/2");
    EXPECT_EQ(root_text(notation, 1.0 / std::sqrt(3.0)), "√3/3");
}

TEST(RootText, writes_other_numbers_as_they_are) {
    const Notation notation;
    EXPECT_EQ(root_text(notation, 0.5), "1/2");
    EXPECT_EQ(root_text(notation, 3.0), "3");
    EXPECT_EQ(root_text(notation, 0.7071), "0.7071");
    EXPECT_EQ(root_text(notation, -std::sqrt(0.5)), "−0.7071");
    EXPECT_EQ(root_text(notation, 1e-3), exact_text(notation, 1e-3));
    Notation decimals;
    decimals.numbers = NumberStyle::decimals;
    EXPECT_EQ(root_text(decimals, std::sqrt(0.5)), "0.7071");
}

}  // namespace
}  // namespace batten::editor
