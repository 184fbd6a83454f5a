#include <gtest/gtest.h>

#include <fstream>

#include "exchange/curve_file.h"

namespace batten::exchange {

TEST(Formats, StandInTheOrderOfTheirNames) {
    ASSERT_EQ(all_formats().size(), core::Names<Format>::table.size());
    for (std::size_t i = 0; i < all_formats().size(); ++i)
        EXPECT_EQ(all_formats()[i].format, core::Names<Format>::table[i].value);
}

TEST(Formats, AreFoundByTheLongestEndingInAnyCase) {
    EXPECT_EQ(format_of("drawings/hull.DXF"), Format::dxf);
    EXPECT_EQ(format_of("hull.v2.stp"), Format::step);
    EXPECT_EQ(format_of("hull.tinyspline.json"), Format::tinyspline);
    EXPECT_EQ(format_of("hull.json"), std::nullopt);
    EXPECT_EQ(format_of("hull"), std::nullopt);
    EXPECT_EQ(format_of(".svg"), std::nullopt);
}

// As a file of Rhino's numbers that is called one of tinyspline.
TEST(CurveFile, AdvisesAnotherFormatOfJson) {
    const std::string path = testing::TempDir() + "advised.tinyspline.json";
    std::ofstream(path)
        << R"({"style": "rhino", "curves": [{"degree": 1, "knots": [0, 1], "points": [[0, 0], [1, 1]]}]})";
    const auto refused = load_curves(path, Format::tinyspline);
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().what.ends_with("; it looks like a Rhino-style file, a format that has to be chosen"))
        << refused.error().what;
    EXPECT_TRUE(load_curves(path, Format::rhino));
    std::ofstream(path) << R"({"style": "rhino", "curves": [{"degree": 1}]})";
    EXPECT_EQ(load_curves(path, Format::rhino).error().what.find("looks like"), std::string::npos);
}

}  // namespace batten::exchange
