#include "exchange/font_reader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/document/file_text.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/area.h"

namespace batten::exchange {

namespace {

using core::Curve;
using core::Point;

std::string font_file(const std::string& name) {
    return *core::read_bytes(std::filesystem::path(BATTEN_EXCHANGE_DATA) / name);
}

Imported set(const std::string& font, const Lettering& lettering) {
    auto imported = read_glyphs(font_file(font), lettering);
    EXPECT_TRUE(imported) << (imported ? "" : imported.error().sentence());
    return imported ? *std::move(imported) : Imported{};
}

const Curve& curve_of(const Imported& imported, std::size_t index) {
    return *imported.document.curves.at(index).curve;
}

std::vector<Point> joints_of(const Curve& curve) {
    std::vector<Point> joints;
    for (double u = curve.domain().lower; u < curve.domain().upper; u += 1.0)
        joints.push_back(core::point_at(curve, u));
    return joints;
}

}  // namespace

TEST(Fonts, GiveQuadraticOutlinesOfTrueType) {
    const Imported imported = set("quadratic.ttf", {.text = "o"});
    ASSERT_EQ(imported.document.curves.size(), 2U);
    const Curve& outer = curve_of(imported, 0);
    EXPECT_EQ(outer.degree(), 2);
    EXPECT_TRUE(outer.is_periodic());
    EXPECT_FALSE(outer.is_rational());
    EXPECT_EQ(outer.control_points().size(), 8U);
    // Four parabolas in the corners of a square of 400: two thirds of each corner's triangle are inside.
    EXPECT_NEAR(std::abs(core::enclosed_area(outer)->signed_area), 400.0 * 400.0 - 4 * 200.0 * 200.0 / 6, 1e-9);
    for (const Point joint : joints_of(outer))
        EXPECT_EQ(std::abs(joint.x - 300) + std::abs(joint.y - 200), 200) << joint.x << ", " << joint.y;
    EXPECT_EQ(curve_of(imported, 1).degree(), 1);
    EXPECT_EQ(core::enclosed_area(curve_of(imported, 1))->signed_area * core::enclosed_area(outer)->signed_area < 0,
              true)
        << "the inner contour goes around the other way";
    EXPECT_EQ(imported.document.curves[0].name, "o");
    EXPECT_EQ(imported.document.curves[1].name, "o 2");
    EXPECT_EQ(imported.document.curves[1].group, "o");
    EXPECT_EQ(imported.report.largest_error, 0.0);
}

TEST(Fonts, GiveImpliedPointsAtHalvesOfUnits) {
    const Imported imported = set("quadratic.ttf", {.text = "c"});
    for (const Point joint : joints_of(curve_of(imported, 0)))
        EXPECT_EQ(std::abs(joint.x - 50.5) + std::abs(joint.y - 50.5), 50.5) << joint.x << ", " << joint.y;
}

TEST(Fonts, GiveCubicOutlinesOfPostScript) {
    const Imported imported = set("cubic.otf", {.text = "o"});
    ASSERT_EQ(imported.document.curves.size(), 2U);
    const Curve& outer = curve_of(imported, 0);
    EXPECT_EQ(outer.degree(), 3);
    EXPECT_EQ(outer.control_points().size(), 12U);
    // Half of the way along a quarter from (500, 200) by (500, 310), (410, 400) to (300, 400).
    bool has_middle = false;
    for (double u = 0.5; u < 4.0; u += 1.0)
        has_middle = has_middle || core::point_at(outer, u) == Point(441.25, 341.25);
    EXPECT_TRUE(has_middle);
}

TEST(Fonts, SetLettersByAdvanceAndKerning) {
    const Imported imported = set("quadratic.ttf", {.text = "Lo oL\nL", .position = {10, 20}});
    const auto& curves = imported.document.curves;
    ASSERT_EQ(curves.size(), 7U);
    const auto left_of = [&](std::size_t i) {
        double left = 1e9;
        for (const Point point : curves[i].curve->control_points()) left = std::min(left, point.x);
        return left;
    };
    EXPECT_EQ(left_of(0), 10 + 50);
    EXPECT_EQ(left_of(1), 10 + 500 - 120 + 100) << "the pair Lo is moved together by 120";
    EXPECT_EQ(left_of(3), 10 + 500 - 120 + 600 + 300 + 100) << "after a blank";
    EXPECT_EQ(left_of(5), 10 + 500 - 120 + 600 + 300 + 600 + 50);
    EXPECT_EQ(left_of(6), 10 + 50) << "another line";
    EXPECT_LT(core::point_at(*curves[6].curve, 0).y, 20.0);
    EXPECT_EQ(curves[5].name, "L 2");
    EXPECT_EQ(curves[3].group, "o 3");
}

TEST(Fonts, AreScaledToTheSizeOfTheirEm) {
    const Imported plain = set("cubic.otf", {.text = "L"});
    const Imported scaled = set("cubic.otf", {.text = "L", .position = {1, 2}, .size = 250.0});
    for (std::size_t i = 0; i < 6; ++i) {
        const Point point = curve_of(plain, 0).control_points()[i];
        EXPECT_EQ(curve_of(scaled, 0).control_points()[i], Point(1 + point.x / 4, 2 + point.y / 4));
    }
}

TEST(Fonts, FindLettersByUnicode) {
    EXPECT_EQ(curve_of(set("cubic.otf", {.text = "ä"}), 0).control_points().size(), 3U);
    EXPECT_EQ(set("cubic.otf", {.text = "äЖ"}).report.left_out,
              std::vector<std::string>{"the font has no 'Ж', which is left out"});
    EXPECT_EQ(
        set("cubic.otf", {.text = "äЖx"}).report.left_out,
        std::vector<std::string>{"the font does not have 2 of the characters, the first one 'Ж'; they are left out"});
    const auto refusal = [](const std::string& text) {
        return read_glyphs(font_file("cubic.otf"), {.text = text}).error().sentence();
    };
    EXPECT_EQ(refusal("Ж"), "the font has no 'Ж', which is left out");
    EXPECT_EQ(refusal("L\xff"), "byte 2 of the text is no UTF-8");
    EXPECT_EQ(refusal(" "), "the text has no letter that is drawn");
    EXPECT_EQ(refusal(""), "the text has no letter that is drawn");
    EXPECT_EQ(refusal(std::string(20000, 'L')), "the text has more than 10000 characters, the most that are set");
}

TEST(Fonts, WithTooManyPointsAreReadInPart) {
    // An L has 6 points.
    const auto read = [](std::size_t most) { return read_glyphs(font_file("quadratic.ttf"), {.text = "L LL"}, most); };
    EXPECT_EQ(read(18)->document.curves.size(), 3U);
    EXPECT_TRUE(read(18)->report.left_out.empty());
    EXPECT_EQ(read(17)->document.curves.size(), 2U);
    EXPECT_EQ(
        read(17)->report.left_out,
        std::vector<std::string>{"only the first 3 characters are drawn, since the outlines of one more would make "
                                 "more than 17 points"});
    EXPECT_FALSE(read(5));
}

TEST(Fonts, OfPixelsAreRefused) {
    const std::string pixels =
        "STARTFONT 2.1\nFONT -a-b-medium-r-normal--8-80-75-75-c-80-iso10646-1\nSIZE 8 75 75\nFONTBOUNDINGBOX 8 8 0 0\n"
        "STARTPROPERTIES 2\nFONT_ASCENT 8\nFONT_DESCENT 0\nENDPROPERTIES\nCHARS 1\nSTARTCHAR A\nENCODING 65\nSWIDTH "
        "500 0\n"
        "DWIDTH 8 0\nBBX 8 8 0 0\nBITMAP\n00\n18\n24\n42\n7E\n42\n42\n00\nENDCHAR\nENDFONT\n";
    EXPECT_EQ(read_glyphs(pixels, {.text = "A"}).error().sentence(),
              "this font has pictures of pixels only; one with outlines is needed");
}

TEST(Fonts, MayBeDamagedAnywhere) {
    EXPECT_EQ(read_glyphs("", {.text = "A"}).error().sentence(),
              "this is no font, or a damaged one; TrueType, OpenType and Type 1 are read");
    for (const char* name : {"quadratic.ttf", "cubic.otf"}) {
        const std::string font = font_file(name);
        for (std::size_t size = 0; size < font.size(); ++size) {
            const auto imported = read_glyphs(font.substr(0, size), {.text = "Loä"});
            EXPECT_TRUE(imported || !imported.error().what.empty());
        }
        for (std::size_t i = 0; i < font.size(); ++i)
            for (const char byte : {'\0', '\xff', '\x7f'}) {
                std::string changed = font;
                changed[i] = byte;
                const auto imported = read_glyphs(changed, {.text = "Loä"});
                EXPECT_TRUE(imported || !imported.error().what.empty());
            }
    }
}

}  // namespace batten::exchange
