#include <gtest/gtest.h>

#include <fstream>

#include "exchange/curve_file.h"
#include "exchange/file_advice.h"

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
    EXPECT_TRUE(
        refused.error().what.ends_with("; it looks like a file in the format Rhino-style, which has to be chosen"))
        << refused.error().what;
    EXPECT_TRUE(load_curves(path, Format::rhino));
    std::ofstream(path) << R"({"style": "rhino", "curves": [{"degree": 1}]})";
    EXPECT_EQ(load_curves(path, Format::rhino).error().what.find("looks like"), std::string::npos);
}

// What a user may well have instead of a drawing, under any name.
TEST(CurveFile, AdvisesWhatToDoWithOtherFiles) {
    const auto advice = [](const std::string& name, const std::string& bytes, std::optional<Format> read) {
        const std::string path = testing::TempDir() + name;
        std::ofstream(path, std::ios::binary) << bytes;
        const std::string told = read ? load_curves(path, *read).error().what : with_advice({"", "why"}, path).what;
        return told.substr(told.rfind("; ") + 2);
    };
    EXPECT_EQ(advice("drawing.svgz", "\x1f\x8b\x08", std::nullopt),
              "it is compressed, and can be read when it is unpacked, or saved as plain SVG");
    EXPECT_EQ(advice("drawing.svg", "\x1f\x8b\x08", Format::svg),
              "it is compressed, and can be read when it is unpacked, or saved as plain SVG");
    EXPECT_EQ(advice("drawing", "<?xml version='1.0'?>\n<svg/>", std::nullopt),
              "it looks like a file in the format SVG, which has to be chosen");
    EXPECT_EQ(advice("part.txt", "ISO-10303-21;", std::nullopt),
              "it looks like a file in the format STEP, which has to be chosen");
    EXPECT_EQ(advice("hull.txt", "  0\r\nSECTION\r\n", std::nullopt),
              "it looks like a file in the format DXF, which has to be chosen");
    EXPECT_EQ(advice("page.pdf", "%PDF-1.4", std::nullopt),
              "it looks like a PDF file, which programs that draw, such as Inkscape, can write as SVG");
    EXPECT_EQ(advice("photo.json", "\x89PNG\r\n", std::nullopt),
              "it looks like a picture, which can be added below the curves and traced (add-picture)");
    EXPECT_EQ(advice("hull.dwg", "AC1032", std::nullopt),
              "it looks like a DWG file, which programs that made it can write as DXF");
    EXPECT_EQ(advice("hull.dxf", "AC1032", Format::dxf), "save it as DXF to read it") << "said by the reader";
}

}  // namespace batten::exchange
