#include "app/editor/words/clauses.h"

#include <gtest/gtest.h>

namespace {

using batten::editor::shorter_beginnings;
using Texts = std::vector<std::string>;

TEST(Clauses, end_at_commas_and_between_hints_the_longest_first) {
    EXPECT_EQ(shorter_beginnings("Drag a control point, and the parameter u along the curve."),
              Texts{"Drag a control point …"});
    EXPECT_EQ(
        shorter_beginnings("Drag the handles of the box, its sides or what is in it · drag around points · Escape"),
        (Texts{"Drag the handles of the box, its sides or what is in it · drag around points …",
               "Drag the handles of the box, its sides or what is in it …", "Drag the handles of the box …"}));
}

TEST(Clauses, keep_the_full_stop_of_a_sentence) {
    EXPECT_EQ(shorter_beginnings("It is 1.5 wide. It turns: look."),
              (Texts{"It is 1.5 wide. It turns …", "It is 1.5 wide. …"}));
}

TEST(Clauses, do_not_end_inside_a_pair_of_coordinates) {
    EXPECT_EQ(shorter_beginnings("Moved from (−6, 0.125) by x; the curve moved"),
              Texts{"Moved from (−6, 0.125) by x …"});
    EXPECT_EQ(shorter_beginnings("N_{i, 3} is one word"), Texts{});
}

TEST(Clauses, end_before_an_aside_and_before_a_dot_that_is_left_over) {
    EXPECT_EQ(shorter_beginnings("Paint over the part (changes the shape) · the wheel"),
              (Texts{"Paint over the part (changes the shape) …", "Paint over the part …"}));
    EXPECT_EQ(shorter_beginnings("Click two points ·"), Texts{"Click two points …"});
}

TEST(Clauses, are_never_the_whole_text) {
    EXPECT_EQ(shorter_beginnings(""), Texts{});
    EXPECT_EQ(shorter_beginnings("One."), Texts{});
    EXPECT_EQ(shorter_beginnings("One,"), Texts{"One …"});
}

}  // namespace
