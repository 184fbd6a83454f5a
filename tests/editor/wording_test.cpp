#include "app/editor/wording.h"

#include <gtest/gtest.h>

namespace batten::editor {
namespace {

TEST(Wording, says_what_an_edit_did_to_the_shape) {
    EXPECT_EQ(done_sentence("Inserted knot 0.5", ShapeEffect::keeps, std::nullopt, std::nullopt),
              "Inserted knot 0.5: the curve is unchanged");
    EXPECT_EQ(done_sentence("Moved P₅", ShapeEffect::changes, 0.12, std::nullopt),
              "Moved P₅: deviates by at most 0.12");
    EXPECT_EQ(done_sentence("Made knots custom", ShapeEffect::changes, 0.0, std::nullopt),
              "Made knots custom: the curve is unchanged");
    EXPECT_EQ(done_sentence("Fitted curve", ShapeEffect::none, std::nullopt, 0.25), "Fitted curve: error at most 0.25");
    EXPECT_EQ(done_sentence("Pasted", ShapeEffect::none, std::nullopt, std::nullopt), "Pasted");
}

}  // namespace
}  // namespace batten::editor
