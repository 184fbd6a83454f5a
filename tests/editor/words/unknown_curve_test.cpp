#include "app/editor/words/unknown_curve.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace batten::editor {
namespace {

core::Document document_of(const std::vector<std::string>& names) {
    core::Document document;
    for (const std::string& name : names) document.curves.emplace_back().name = name;
    return document;
}

TEST(UnknownCurve, IsToldWithTheNearestName) {
    EXPECT_EQ(unknown_curve(document_of({"circle", "wave"}), "wav"), "there is no curve 'wav'; did you mean 'wave'?");
}

TEST(UnknownCurve, IsToldWithNamesAndNumbers) {
    EXPECT_EQ(unknown_curve(document_of({}), "2"), "there is no curve '2', and no other one");
    EXPECT_EQ(unknown_curve(document_of({"wave"}), "2"), "there is no curve '2'; there is only 'wave', number 0");
    EXPECT_EQ(unknown_curve(document_of({"wave", "circle"}), "2"),
              "there is no curve '2'; there are 'wave', 'circle', with the numbers 0 to 1");
}

TEST(UnknownCurve, IsToldWithTenNamesOfMany) {
    std::vector<std::string> names;
    for (int i = 0; i < 100000; ++i) names.push_back("curve " + std::to_string(i));
    EXPECT_EQ(
        unknown_curve(document_of(names), "x"),
        "there is no curve 'x'; there are 100000, with the numbers 0 to 99999, first 'curve 0', 'curve 1', 'curve "
        "2', 'curve 3', 'curve 4', 'curve 5', 'curve 6', 'curve 7', 'curve 8', 'curve 9'");
}

}  // namespace
}  // namespace batten::editor
