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

namespace {

// What is told behind why a file is not read in the format, or as one of Batten itself; "why" where nothing is.
std::string advice(const std::string& name, const std::string& bytes, std::optional<Format> read) {
    const std::string path = testing::TempDir() + name;
    std::ofstream(path, std::ios::binary) << bytes;
    const std::string told = read ? load_curves(path, *read).error().what : with_advice({"", "why"}, path).what;
    const std::size_t end_of_problem = told.rfind("; ");
    return end_of_problem == std::string::npos ? told : told.substr(end_of_problem + 2);
}

// One line from (0, 0) to (1, 1) as each of them keeps it.
constexpr const char* of_rhino = R"({"curves": [{"degree": 1, "points": [[0, 0], [1, 1]], "knots": [0, 1]}]})";
constexpr const char* of_opencascade =
    R"({"curves": [{"degree": 1, "poles": [[0, 0], [1, 1]], "knots": [0, 1], "multiplicities": [2, 2]}]})";
constexpr const char* of_tinyspline =
    R"({"degree": 1, "dimension": 2, "control_points": [0, 0, 1, 1], "knots": [0, 0, 1, 1]})";
constexpr const char* of_nurbs_python =
    R"({"shape": {"type": "curve", "count": 1, "data": [{"degree": 1, "knotvector": [0, 0, 1, 1],
        "control_points": {"points": [[0, 0], [1, 1]]}}]}})";
constexpr const char* of_batten =
    R"({"format": "batten", "version": 1, "curves": [{"name": "a", "degree": 1, "points": [[0, 0], [1, 1]],
        "knots": [0, 0, 1, 1]}]})";

}  // namespace

TEST(CurveFile, AdvisesTheFormatOfEachJson) {
    const std::vector<std::pair<Format, const char*>> all{{Format::rhino, of_rhino},
                                                          {Format::opencascade, of_opencascade},
                                                          {Format::tinyspline, of_tinyspline},
                                                          {Format::nurbs_python, of_nurbs_python}};
    for (const auto& [format, text] : all) {
        const std::string expected =
            "it looks like a file in the format " + std::string(core::title_of(format)) + ", which has to be chosen";
        EXPECT_EQ(advice("curves.json", text, std::nullopt), expected);
        EXPECT_EQ(advice("curves.txt", text, Format::svg), expected);
        for (const auto& [other, other_text] : all) {
            if (other == format) continue;
            EXPECT_EQ(advice("curves.json", text, other), expected);
        }
        EXPECT_TRUE(load_curves(testing::TempDir() + "curves.json", format)) << expected;
    }
}

// As GeoJSON, and as anything that has a size.
TEST(CurveFile, AdvisesNothingForOtherJson) {
    for (const char* text : {R"({"shape": {"type": "Feature"}, "x": 1})", R"({"dimension": 2, "data": [1, 2]})", "[]"})
        EXPECT_EQ(advice("geo.json", text, std::nullopt), "why") << text;
}

TEST(CurveFile, AdvisesTheFormatOfJsonBehindAByteOrderMark) {
    EXPECT_EQ(advice("mark.txt", std::string("\xEF\xBB\xBF") + of_tinyspline, std::nullopt),
              "it looks like a file in the format tinyspline, which has to be chosen");
}

TEST(CurveFile, AdvisesTheNameOfItsOwnFiles) {
    for (const Format format : {Format::svg, Format::dxf, Format::rhino, Format::tinyspline})
        EXPECT_EQ(advice("own.txt", of_batten, format),
                  "it looks like a file of Batten itself: choose no format, and let its name end in .json alone");
    EXPECT_EQ(advice("own.rhino.json", std::string("\xEF\xBB\xBF") + of_batten, Format::rhino),
              "it looks like a file of Batten itself: choose no format, and let its name end in .json alone");
    EXPECT_EQ(advice("own.txt", of_batten, std::nullopt), "why");
    // A drawing may hold such a file, and a curve of another format may have that name.
    EXPECT_EQ(advice("drawing.dxf", "<svg>{\"format\": \"batten\"}</svg>", Format::dxf),
              "it looks like a file in the format SVG, which has to be chosen");
    EXPECT_EQ(advice("named.json", R"({"curves": [{"name": "batten", "poles": []}]})", Format::rhino),
              "it looks like a file in the format OpenCASCADE-style, which has to be chosen");
    EXPECT_EQ(advice("drawing.dxf", "<svg class=\"shape\"/>", Format::dxf),
              "it looks like a file in the format SVG, which has to be chosen");
}

// By the first bytes of TrueType, OpenType, collections, WOFF, WOFF2 and Type 1.
TEST(CurveFile, AdvisesTheCommandThatReadsFonts) {
    using namespace std::string_literals;
    const char* expected = "it looks like a font, of whose letters 'text-outlines' makes curves";
    for (const std::string& bytes :
         {"\0\1\0\0\0\x0c"s, "OTTO\0\x0b"s, "ttcf\0\1\0\0"s, "true\0\x0a"s, "wOFF\0\1\0\0"s, "wOF2OTTO"s,
          "\x80\x01\x12\x34\0\0%!PS-AdobeFont-1.0"s, "%!PS-AdobeFont-1.0: x"s, "%!FontType1-1.0: x"s}) {
        EXPECT_EQ(advice("letters.otf", bytes, std::nullopt), expected) << bytes;
        EXPECT_EQ(advice("letters.svg", bytes, Format::svg), expected) << bytes;
    }
    for (const char* name : {"cubic.otf", "quadratic.ttf"})
        EXPECT_EQ(with_advice({"", "why"}, std::filesystem::path(BATTEN_EXCHANGE_DATA) / name).what,
                  "why; "s + expected);
}

// What a user may well have instead of a drawing, under any name.
TEST(CurveFile, AdvisesWhatToDoWithOtherFiles) {
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
    for (const char* content :
         {"\x14[Content_Types].xml..xl/workbook.xml", "\x14mimetypeapplication/vnd.oasis.opendocument.spreadsheetPK"})
        EXPECT_EQ(advice("points.bin", std::string("PK\x03\x04") + content, std::nullopt),
                  "it looks like a spreadsheet, which has to be saved as CSV");
    EXPECT_EQ(advice("drawings.zip", "PK\x03\x04\x14hull.dxf", std::nullopt),
              "it looks like a compressed folder, whose files can be read when it is unpacked");
    EXPECT_EQ(advice("hull.dwg", "AC1032", std::nullopt),
              "it looks like a DWG file, which programs that made it can write as DXF");
    EXPECT_EQ(advice("hull.dxf", "AC1032", Format::dxf), "save it as DXF to read it") << "said by the reader";
}

}  // namespace batten::exchange
