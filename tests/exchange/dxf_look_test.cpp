#include <gtest/gtest.h>

#include "exchange/dxf/dxf_reader.h"

namespace batten::exchange {

namespace {

// A drawing with these groups, separated by blanks, among its layers and its entities.
Imported drawing_of(const std::string& layers, const std::string& entities) {
    std::string text = "0 SECTION 2 TABLES 0 TABLE 2 LAYER" + layers + " 0 ENDTAB 0 ENDSEC 0 SECTION 2 ENTITIES" +
                       entities + " 0 ENDSEC 0 EOF\n";
    for (char& c : text)
        if (c == ' ') c = '\n';
    auto found = read_dxf(text);
    EXPECT_TRUE(found) << found.error().sentence();
    return found ? *std::move(found) : Imported{};
}

// What is told of the look of a drawing, in which nothing of the curves is lost.
std::vector<std::string> looks_of(const std::string& layers, const std::string& entities) {
    const Imported found = drawing_of(layers, entities);
    EXPECT_TRUE(found.report.left_out.empty());
    return found.report.looks;
}

using Told = std::vector<std::string>;

// An entity of a layer with more groups, and the ends of a line or the corners of a polyline.
std::string line_on(const std::string& layer, const std::string& groups = "") {
    return " 0 LINE 8 " + layer + groups + " 10 0 20 0 11 1 21 1";
}
const std::string corners = " 10 0 20 0 10 1 20 1";

constexpr const char* width = "the width of a polyline is left out, of which the middle is read";
constexpr const char* line_type = "the line type of a curve is left out, since all curves are drawn as whole lines";
constexpr const char* line_weight =
    "the line weight of a curve is left out, since all curves are drawn alike but for their colors";
constexpr const char* thickness = "the thickness of a curve, its height above the plane, is left out";

}  // namespace

TEST(DxfLook, TellsWidthsOfPolylines) {
    EXPECT_EQ(looks_of("", " 0 LWPOLYLINE 43 0.5" + corners), Told{width});
    EXPECT_EQ(looks_of("", " 0 LWPOLYLINE 10 0 20 0 40 0 41 0.5 10 1 20 1 40 0.5 41 0"), Told{width}) << "an arrow";
    EXPECT_EQ(looks_of("", " 0 POLYLINE 66 1 40 0.5 41 0.5 0 VERTEX 10 0 20 0 0 VERTEX 10 1 20 1 0 SEQEND"),
              Told{width});
    EXPECT_EQ(looks_of("", " 0 POLYLINE 66 1 0 VERTEX 10 0 20 0 41 2 0 VERTEX 10 1 20 1 0 SEQEND"), Told{width});
    EXPECT_EQ(looks_of("", " 0 LWPOLYLINE 43 0 10 0 20 0 40 0 41 0 10 1 20 1"), Told{});
    EXPECT_EQ(looks_of("", " 0 CIRCLE 10 0 20 0 40 5 0 SPLINE 71 1 43 1e-9 40 0 40 0 40 1 40 1 41 2 41 1" + corners),
              Told{})
        << "a radius, a tolerance, knots and weights have the codes of widths";
}

TEST(DxfLook, TellsLineTypesOfEntitiesAndOfTheirLayers) {
    const std::string dashed = " 0 LAYER 2 axes 6 DASHED";
    EXPECT_EQ(looks_of("", line_on("0", " 6 CENTER")), Told{line_type});
    EXPECT_EQ(looks_of(dashed, line_on("axes")), Told{line_type});
    EXPECT_EQ(looks_of(dashed, line_on("axes", " 6 ByLayer")), Told{line_type});
    EXPECT_EQ(looks_of(dashed, line_on("axes", " 6 CONTINUOUS") + line_on("0", " 6 ByBlock") + line_on("0")), Told{});
    EXPECT_EQ(looks_of(" 0 LAYER 2 hull 6 Continuous", line_on("hull")), Told{});
}

TEST(DxfLook, TellsLineWeightsOfEntitiesAndOfTheirLayers) {
    const std::string bold = " 0 LAYER 2 hull 370 50";
    EXPECT_EQ(looks_of("", line_on("0", " 370 25")), Told{line_weight});
    EXPECT_EQ(looks_of(bold, line_on("hull")), Told{line_weight});
    EXPECT_EQ(looks_of(bold, line_on("hull", " 370 -1")), Told{line_weight});
    EXPECT_EQ(looks_of(bold, line_on("hull", " 370 -3") + line_on("hull", " 370 0")), Told{}) << "the usual, the least";
    EXPECT_EQ(looks_of(" 0 LAYER 2 hull 370 -3", line_on("hull")), Told{});
}

TEST(DxfLook, TellsThicknesses) {
    EXPECT_EQ(looks_of("", line_on("0", " 39 2.5")), Told{thickness});
    EXPECT_EQ(looks_of("", line_on("0", " 39 -2.5")), Told{thickness});
    EXPECT_EQ(looks_of("", line_on("0", " 39 0")), Told{});
}

TEST(DxfLook, CountsCurves) {
    EXPECT_EQ(looks_of("", line_on("0", " 6 CENTER 370 25 39 1") + line_on("0", " 6 DASHED 370 50 39 2") +
                               " 0 LWPOLYLINE 43 1" + corners + " 0 LWPOLYLINE 43 2" + corners),
              (Told{"the line types of 2 curves are left out, since all curves are drawn as whole lines",
                    "the line weights of 2 curves are left out, since all curves are drawn alike but for their colors",
                    "the thicknesses of 2 curves, their heights above the plane, are left out",
                    "the widths of 2 polylines are left out, of which the middles are read"}));
}

TEST(DxfLook, IsNotToldOfWhatIsLeftOut) {
    const Imported found = drawing_of("", line_on("0") + " 0 CIRCLE 39 1 370 25 10 0 20 0 40 -1");
    EXPECT_EQ(found.report.left_out.size(), 1U);
    EXPECT_TRUE(found.report.looks.empty());
}

// Of the index, 1 is red, 5 blue, 7 black or white, and 30 an orange that is not known here; 0 is that of a block.
TEST(DxfLook, ColorsOfLayersAreThoseOfEntitiesWithoutOneAlone) {
    const Imported found =
        drawing_of(" 0 LAYER 2 red 62 1", line_on("red") + line_on("red", " 62 256") + line_on("red", " 62 7") +
                                              line_on("red", " 62 30") + line_on("red", " 62 0") +
                                              line_on("red", " 62 5") + line_on("red", " 62 256 420 258"));
    std::vector<std::optional<core::DocumentColor>> colors;
    for (const core::DocumentCurve& entry : found.document.curves) colors.push_back(entry.color);
    const core::DocumentColor red{255, 0, 0};
    EXPECT_EQ(colors, (std::vector<std::optional<core::DocumentColor>>{red, red, std::nullopt, std::nullopt,
                                                                       std::nullopt, core::DocumentColor{0, 0, 255},
                                                                       core::DocumentColor{0, 1, 2}}));
}

TEST(DxfLook, CurvesAreReadWhoseThicknessOrWeightIsNoNumber) {
    const Imported found = drawing_of("", line_on("0", " 370 1e400") + line_on("0", " 39 thick"));
    EXPECT_EQ(found.document.curves.size(), 2U);
    EXPECT_TRUE(found.report.left_out.empty());
}

TEST(DxfLook, LocksCurvesOfLockedLayers) {
    const Imported found = drawing_of(" 0 LAYER 2 fixed 70 4 0 LAYER 2 frozen 70 5 0 LAYER 2 free 70 64",
                                      line_on("Fixed") + line_on("frozen") + line_on("free") + line_on("other"));
    const auto& curves = found.document.curves;
    ASSERT_EQ(curves.size(), 4U);
    EXPECT_TRUE(curves[0].locked);
    EXPECT_TRUE(curves[0].visible);
    EXPECT_TRUE(curves[1].locked);
    EXPECT_FALSE(curves[1].visible);
    EXPECT_FALSE(curves[2].locked);
    EXPECT_FALSE(curves[3].locked);
}

}  // namespace batten::exchange
