#include "app/editor/words/nearest_name.h"

#include <gtest/gtest.h>

#include <vector>

namespace batten::editor {
namespace {

std::optional<std::string> nearest(std::string_view typed, const std::vector<std::string>& names) {
    return nearest_name(typed, names);
}

TEST(NearestName, ForgivesOneLetterInThree) {
    // Of seven letters two may be wrong, of five one.
    EXPECT_EQ(nearest("polugen", {"polygon"}), "polygon");
    EXPECT_EQ(nearest("pulugen", {"polygon"}), std::nullopt);
    EXPECT_EQ(nearest("nots", {"knots"}), "knots");
    EXPECT_EQ(nearest("not", {"knots"}), std::nullopt);
    EXPECT_EQ(nearest("knotss", {"knots"}), "knots");
    EXPECT_EQ(nearest("titel", {"title"}), "title") << "two neighbors that change places are one slip";
    EXPECT_EQ(nearest("sgv", {"svg"}), "svg");
    EXPECT_EQ(nearest("o", {"h"}), std::nullopt);
    EXPECT_EQ(nearest("", {"h", "svg"}), std::nullopt);
}

TEST(NearestName, TakesTheFirstOfTheNearest) {
    EXPECT_EQ(nearest("rats", {"rational", "rates", "rate"}), "rates");
    EXPECT_EQ(nearest("heght", {"width", "weight", "height"}), "height");
    EXPECT_EQ(nearest("boat", {"goat", "coat"}), "goat");
}

TEST(NearestName, IsOneThatBeginsSo) {
    EXPECT_EQ(nearest("transp", {"theme", "transparent"}), "transparent");
    EXPECT_EQ(nearest("tr", {"transparent"}), std::nullopt);
    EXPECT_EQ(nearest("knot", {"knot-questions", "knots"}), "knots") << "with one letter missing";
}

TEST(NearestName, IsFoundWhateverTheCase) {
    EXPECT_EQ(nearest("DXF", {"svg", "dxf"}), "dxf");
    EXPECT_EQ(nearest("wave", {"Wave"}), "Wave");
}

TEST(NearestName, OfAnEndlessWordThereIsNone) {
    EXPECT_EQ(nearest(std::string(100'000'000, 'x'), {"svg", "dxf"}), std::nullopt);
}

}  // namespace
}  // namespace batten::editor
