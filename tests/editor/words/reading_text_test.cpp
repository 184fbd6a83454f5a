#include "app/editor/words/reading_text.h"

#include <gtest/gtest.h>

namespace batten::editor {
namespace {

TEST(ReadingText, six_digits_are_enough_to_read) {
    EXPECT_EQ(reading_text("wave has the length 3.141592653589793"), "wave has the length 3.14159");
    EXPECT_EQ(reading_text("at (0.1, 1.2345678e-7)"), "at (0.1, 1.23457e\u22127)");
    EXPECT_EQ(reading_text("1234567 points, 12.25 s, 1e+20"), "1234567 points, 12.25 s, 1e20");
    EXPECT_EQ(reading_text("it is 0.99999999."), "it is 1.");
    EXPECT_EQ(reading_text("a turn of 26.565051177077994° and -0.1234567°"), "a turn of 26.5651° and −0.123457°");
}

TEST(ReadingText, minus_signs_are_true_ones) {
    EXPECT_EQ(reading_text("from -1 to (-0.5, -2e-05)"), "from \u22121 to (\u22120.5, \u22122e\u22125)");
    EXPECT_EQ(reading_text("[-1, -3.00000001]"), "[\u22121, \u22123]");
}

TEST(ReadingText, bounds_are_rounded_up) {
    EXPECT_EQ(reading_text("moved by at most 1.2345671"), "moved by at most 1.23457");
    EXPECT_EQ(reading_text("moved by at most 1.2345601"), "moved by at most 1.23457");
    EXPECT_EQ(reading_text("moved by at most 5.000000000000001"), "moved by at most 5");
    EXPECT_EQ(reading_text("moved by at most 5.0000000001"), "moved by at most 5.00001");
    EXPECT_EQ(reading_text("moved by 1.2345601"), "moved by 1.23456");
    EXPECT_EQ(reading_text("error at most 1.2e-08"), "error at most 1.2e\u22128");
}

TEST(ReadingText, with_all_digits_only_the_signs_change) {
    EXPECT_EQ(full_reading_text("u = -0.3333333333333333, 4.4e-16"), "u = −0.3333333333333333, 4.4e−16");
}

TEST(ReadingText, names_stay_as_they_are) {
    EXPECT_EQ(reading_text("saved 'wave -1.23456789' to run-2.json on 2026-11-22"),
              "saved 'wave -1.23456789' to run-2.json on 2026-11-22");
    EXPECT_EQ(reading_text("P₅ and C' x -1, 3.00000001d, v1.23456789"),
              "P₅ and C' x \u22121, 3.00000001d, v1.23456789");
}

TEST(ReadingText, is_brief_for_a_projector) {
    EXPECT_EQ(
        brief_reading_text("Moved P2 from (-1.5, 3.5) to (-0.575342, 2.88356); the curve moved by at most 0.662891 at "
                           "equal parameters, its shape by at most 0.334132"),
        "Moved P2 from (\u22121.5, 3.5) to (\u22120.575, 2.88)");
    EXPECT_EQ(brief_reading_text("Inserted knot 0.123456; it is there twice: C1"),
              "Inserted knot 0.123; it is there twice: C1");
    EXPECT_EQ(brief_reading_text("The distance is at most 0.12345"), "The distance is at most 0.124");
}

}  // namespace
}  // namespace batten::editor
