#include "app/editor/wording.h"

#include <gtest/gtest.h>

namespace batten::editor {
namespace {

TEST(Wording, tells_labels_as_done) {
    EXPECT_EQ(past_of("Insert knot 0.5"), "Inserted knot 0.5");
    EXPECT_EQ(past_of("Move P₅"), "Moved P₅");
    EXPECT_EQ(past_of("Set weight of P₅"), "Set weight of P₅");
    EXPECT_EQ(past_of("Raise degree to 4"), "Raised degree to 4");
    EXPECT_EQ(past_of("Add P₂"), "Added P₂");
    EXPECT_EQ(past_of("Make knots uniform"), "Made knots uniform");
    EXPECT_EQ(past_of("Draw curve"), "Drew curve");
    EXPECT_EQ(past_of("Hide curve 'a'"), "Hid curve 'a'");
    EXPECT_EQ(past_of("Paste"), "Pasted");
}

TEST(Wording, says_what_an_edit_did_to_the_shape) {
    EXPECT_EQ(edit_sentence("Insert knot 0.5", ShapeEffect::keeps, std::nullopt),
              "Inserted knot 0.5: the curve is unchanged");
    EXPECT_EQ(edit_sentence("Move P₅", ShapeEffect::changes, 0.12), "Moved P₅: deviates by at most 0.12");
    EXPECT_EQ(edit_sentence("Make knots custom", ShapeEffect::changes, 0.0),
              "Made knots custom: the curve is unchanged");
    EXPECT_EQ(edit_sentence("Paste", ShapeEffect::none, std::nullopt), "Pasted");
}

}  // namespace
}  // namespace batten::editor
