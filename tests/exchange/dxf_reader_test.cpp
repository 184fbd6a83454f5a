#include "exchange/dxf/dxf_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/evaluate/evaluate.h"
#include "tests/core/point_at_share.h"

namespace batten::exchange {

namespace {

using core::Curve;
using core::Point;

constexpr double pi = std::numbers::pi;

// A drawing with these groups, separated by blanks, among its entities. Before them are six lines.
std::string drawing(std::string_view entities) {
    std::string text = "0\nSECTION\n2\nENTITIES\n";
    text += entities;
    for (char& c : text)
        if (c == ' ') c = '\n';
    return text + "\n0\nENDSEC\n0\nEOF\n";
}

Imported read(std::string_view entities) {
    auto read = read_dxf(drawing(entities));
    EXPECT_TRUE(read) << read.error().sentence();
    return read ? *std::move(read) : Imported{};
}

Curve curve_of(std::string_view entities) {
    const Imported found = read(entities);
    EXPECT_EQ(found.document.curves.size(), 1U);
    return *found.document.curves.at(0).curve;
}

std::string refusal_of(std::string_view text) {
    const auto found = read_dxf(text);
    return found ? "" : found.error().sentence();
}

void expect_near(Point found, Point expected) {
    EXPECT_NEAR(found.x, expected.x, 4e-15 * (1.0 + std::abs(expected.x)));
    EXPECT_NEAR(found.y, expected.y, 4e-15 * (1.0 + std::abs(expected.y)));
}

void expect_on_circle(const Curve& curve, Point center, double radius) {
    for (int i = 0; i <= 16; ++i)
        EXPECT_NEAR(core::distance(at_share(curve, i / 16.0), center), radius, 1e-14 * radius);
}

}  // namespace

TEST(DxfReader, ReadsLines) {
    const Imported found = read("0 LINE 8 edge 10 1 20 2 11 4 21 6");
    ASSERT_EQ(found.document.curves.size(), 1U);
    EXPECT_EQ(found.document.curves[0].name, "edge");
    EXPECT_EQ(found.report.largest_error, 0.0);
    EXPECT_TRUE(found.report.left_out.empty());
    const Curve& line = *found.document.curves[0].curve;
    EXPECT_EQ(line.degree(), 1);
    EXPECT_EQ(at_share(line, 0.0), (Point{1, 2}));
    EXPECT_EQ(at_share(line, 1.0), (Point{4, 6}));
}

TEST(DxfReader, ReadsArcsCounterclockwiseAlsoOverZero) {
    const Curve arc = curve_of("0 ARC 10 1 20 2 40 2 50 30 51 120");
    expect_near(at_share(arc, 0.0), {1 + std::sqrt(3.0), 3});
    expect_near(at_share(arc, 1.0), {0, 2 + std::sqrt(3.0)});
    expect_near(at_share(arc, 0.5), {1 + 2 * std::cos(75 * pi / 180), 2 + 2 * std::sin(75 * pi / 180)});
    expect_on_circle(arc, {1, 2}, 2);
    const Curve over_zero = curve_of("0 ARC 10 0 20 0 40 1 50 300 51 60");
    expect_near(at_share(over_zero, 0.0), {0.5, -std::sqrt(0.75)});
    expect_near(at_share(over_zero, 0.5), {1, 0});
    expect_near(at_share(over_zero, 1.0), {0.5, std::sqrt(0.75)});
}

TEST(DxfReader, SeesArcsFromAboveThatFaceDown) {
    const Curve arc = curve_of("0 ARC 10 1 20 2 40 2 50 0 51 90 210 0 220 0 230 -1");
    expect_near(at_share(arc, 0.0), {-3, 2});
    expect_near(at_share(arc, 1.0), {-1, 4});
    expect_on_circle(arc, {-1, 2}, 2);
}

TEST(DxfReader, ReadsCircles) {
    const Curve circle = curve_of("0 CIRCLE 10 1e6 20 -2 40 0.5");
    expect_near(at_share(circle, 0.0), {1e6 + 0.5, -2});
    expect_near(at_share(circle, 0.25), {1e6, -1.5});
    EXPECT_EQ(at_share(circle, 1.0), at_share(circle, 0.0));
}

TEST(DxfReader, ReadsEllipses) {
    const Curve whole = curve_of("0 ELLIPSE 10 1 20 2 11 0 21 3 40 0.5 41 0 42 6.283185307179586");
    expect_near(at_share(whole, 0.0), {1, 5});
    expect_near(at_share(whole, 0.25), {-0.5, 2});
    expect_near(at_share(whole, 0.5), {1, -1});
    EXPECT_EQ(at_share(whole, 1.0), at_share(whole, 0.0));
    const Curve part = curve_of("0 ELLIPSE 10 0 20 0 11 4 21 0 40 0.25 41 0.5 42 1.5");
    expect_near(at_share(part, 0.0), {4 * std::cos(0.5), std::sin(0.5)});
    expect_near(at_share(part, 0.5), {4 * std::cos(1.0), std::sin(1.0)});
    expect_near(at_share(part, 1.0), {4 * std::cos(1.5), std::sin(1.5)});
}

TEST(DxfReader, TakesRoundedWholeTurnsOfEllipsesForWhole) {
    for (const char* turn : {"6.28318", "6.28319", "6.283185307"}) {
        const Curve whole = curve_of(std::string("0 ELLIPSE 10 0 20 0 11 4 21 0 40 0.5 41 0 42 ") + turn);
        EXPECT_EQ(at_share(whole, 1.0), at_share(whole, 0.0));
        expect_near(at_share(whole, 0.25), {0, 2});
    }
}

TEST(DxfReader, RunsEllipsesBackwardThatFaceDown) {
    const Curve part = curve_of("0 ELLIPSE 10 1 20 0 11 4 21 0 40 0.25 41 0 42 1 210 0 220 0 230 -1");
    expect_near(at_share(part, 0.0), {5, 0});
    expect_near(at_share(part, 1.0), {1 + 4 * std::cos(1.0), -std::sin(1.0)});
}

TEST(DxfReader, ReadsPolylinesOfDegreeOne) {
    const Curve open = curve_of("0 LWPOLYLINE 90 7 70 0 10 0 20 0 10 2 20 0 10 2 20 0 10 2 20 1");
    EXPECT_EQ(open.degree(), 1);
    EXPECT_FALSE(open.is_periodic());
    EXPECT_EQ(std::vector(open.control_points().begin(), open.control_points().end()),
              (std::vector<Point>{{0, 0}, {2, 0}, {2, 1}}));
    const Curve closed = curve_of("0 LWPOLYLINE 70 1 10 0 20 0 10 2 20 0 10 2 20 1");
    EXPECT_TRUE(closed.is_periodic());
    EXPECT_EQ(closed.control_points().size(), 3U);
}

TEST(DxfReader, ReadsBulgesAsArcs) {
    // To the left a half circle below, back by a straight leg of the same degree.
    const Curve half = curve_of("0 LWPOLYLINE 70 0 10 -1 20 0 42 1 10 1 20 0 10 1 20 4");
    EXPECT_EQ(half.degree(), 2);
    expect_near(core::point_at(half, 1.0), {0, -1});
    expect_near(core::point_at(half, 2.0), {1, 0});
    expect_near(core::point_at(half, 2.5), {1, 2});
    for (const double u : {0.25, 0.5, 1.3, 1.9}) EXPECT_NEAR(core::distance(core::point_at(half, u), {0, 0}), 1, 1e-15);
    // A quarter to the right, in one piece.
    const Curve quarter = curve_of("0 LWPOLYLINE 70 0 10 0 20 0 42 -0.41421356237309503 10 1 20 1");
    EXPECT_EQ(quarter.control_points().size(), 3U);
    expect_near(quarter.control_points()[1], {0, 1});
    EXPECT_NEAR(quarter.weights()[1], std::sqrt(0.5), 1e-15);
    expect_on_circle(quarter, {1, 0}, 1);
    // Three quarters of a circle, from its right to its bottom: tan(270/4).
    const Curve large = curve_of("0 LWPOLYLINE 70 0 10 1 20 0 42 2.414213562373095 10 0 20 -1");
    expect_on_circle(large, {0, 0}, 1);
    expect_near(at_share(large, 0.5), {-std::sqrt(0.5), std::sqrt(0.5)});
}

TEST(DxfReader, ClosesBulgedPolylinesPeriodically) {
    const Curve circle = curve_of("0 LWPOLYLINE 90 2 70 1 10 -1 20 0 42 1 10 1 20 0 42 1");
    EXPECT_TRUE(circle.is_periodic());
    expect_on_circle(circle, {0, 0}, 1);
    expect_near(at_share(circle, 0.0), {-1, 0});
    expect_near(at_share(circle, 0.25), {0, -1});
    expect_near(at_share(circle, 0.75), {0, 1});
}

TEST(DxfReader, ReadsPolylinesOfOldDrawings) {
    const Curve old = curve_of(
        "0 POLYLINE 66 1 10 0 20 0 30 0 70 0 0 VERTEX 10 -1 20 0 42 1 0 VERTEX 10 9 20 9 70 16 0 VERTEX 10 1 20 0 "
        "0 SEQEND 8 0");
    expect_near(at_share(old, 0.5), {0, -1});
    expect_near(at_share(old, 1.0), {1, 0});
}

TEST(DxfReader, BelievesDataAndNotFlagsAndCounts) {
    // Said to be closed, periodic and rational with other counts: an open parabola.
    const Curve curve = curve_of(
        "0 SPLINE 70 7 71 2 72 99 73 -5 74 1000000 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 1 20 2 10 2 20 0 "
        "41 -1 41 -1 41 -1");
    EXPECT_FALSE(curve.is_periodic());
    EXPECT_FALSE(curve.is_rational());
    EXPECT_EQ(at_share(curve, 0.5), (Point{1, 1}));
    // Weights that no flag announces.
    const Curve rational =
        curve_of("0 SPLINE 70 8 71 2 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 1 20 2 10 2 20 0 41 1 41 3 41 1");
    expect_near(at_share(rational, 0.5), {1, 1.5});
}

TEST(DxfReader, BoundsWhatKnotsOutsideAPeriodAreRounded) {
    const std::string points = " 10 0 20 0 10 6 20 0 10 0 20 6 10 0 20 0 10 6 20 0";
    const std::string whole = " 40 -2 40 -1 40 0 40 1 40 2 40 3 40 4 40 5";
    const std::string decimal =
        " 40 -0.19999999999999998 40 -0.09999999999999998 40 0 40 0.1 40 0.2 40 0.3 40 0.4 40 0.5";
    const Imported exact = read("0 SPLINE 70 3 71 2" + whole + points);
    EXPECT_TRUE(exact.document.curves.at(0).curve->is_periodic());
    EXPECT_EQ(exact.report.largest_error, 0.0);
    // 0.1 + 0.3 is rounded by 2^-55: half a leg of length 6 is off by 6 * 2.5 times that.
    const Imported rounded = read("0 SPLINE 70 3 71 2" + decimal + points);
    EXPECT_TRUE(rounded.document.curves.at(0).curve->is_periodic());
    EXPECT_GE(rounded.report.largest_error, 15 * 0x1p-55);
    EXPECT_LE(rounded.report.largest_error, 5 * 15 * 0x1p-55);
    const Imported fitted = read("0 SPLINE 70 1 71 3 11 0 21 0 11 3 21 4 11 0 21 6 11 -3 21 4");
    EXPECT_EQ(fitted.report.largest_error, 0.0) << "whose knots are not those of the file";
}

TEST(DxfReader, RefusesWrongCountsOfKnotsAndWeights) {
    EXPECT_EQ(refusal_of(drawing("0 SPLINE 71 2 40 0 40 0 40 1 40 1 10 0 20 0 10 1 20 2 10 2 20 0")),
              "SPLINE at line 6 was left out: the number of knots is 4; for 3 control points of degree 2 it must be 6, "
              "points + degree + 1, while 4, points + degree − 1, is Rhino-style");
    EXPECT_EQ(refusal_of(drawing("0 SPLINE 10 0 20 0 10 1 20 2 10 2 20 0")),
              "SPLINE at line 6 was left out: its degree is 0, but it must be a whole number from 1 to 25");
    EXPECT_EQ(
        refusal_of(drawing("0 SPLINE 71 2 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 1 20 2 10 2 20 0 41 1 41 2")),
        "SPLINE at line 6 was left out: 2 weights were found for 3 control points; there must be one for each point, "
        "or none at all");
}

TEST(DxfReader, TakesWeightsOfMinusOneForNoneOnlyWhereAllAre) {
    const std::string spline = "0 SPLINE 71 2 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 1 20 2 10 2 20 0 ";
    EXPECT_FALSE(read(spline + "41 -1 41 -1 41 -1").document.curves.at(0).curve->is_rational());
    EXPECT_TRUE(
        refusal_of(drawing(spline + "41 1 41 -1 41 1")).starts_with("SPLINE at line 6 was left out: weight 1 is -1"));
}

TEST(DxfReader, InterpolatesFitPointsAndSaysSo) {
    const Imported found = read("0 SPLINE 71 3 74 4 11 0 21 0 11 1 21 1 11 2 21 0 11 3 21 1");
    ASSERT_EQ(found.document.curves.size(), 1U);
    EXPECT_EQ(at_share(*found.document.curves[0].curve, 1.0), (Point{3, 1}));
    EXPECT_EQ(
        found.report.left_out,
        std::vector<std::string>{"SPLINE at line 6 has only points that it passes; a curve through them was made, "
                                 "which may be another between them"});
}

TEST(DxfReader, GivesSplinesThroughFitPointsTheirTangents) {
    // As cubic and quadratic Bézier curves: the derivative at an end is 5, the length of the polygon, and its third or
    // half is the way to the next control point.
    const Curve both = curve_of("0 SPLINE 71 3 12 1 22 0 32 0 13 0 23 2 33 0 11 0 21 0 11 3 21 4");
    ASSERT_EQ(both.control_points().size(), 4U);
    expect_near(both.control_points()[1], {5.0 / 3.0, 0});
    expect_near(both.control_points()[2], {3, 4 - 5.0 / 3.0});
    expect_near(at_share(both, 0.5), {17.0 / 8.0, 11.0 / 8.0});
    const Curve first = curve_of("0 SPLINE 71 3 12 -3 22 0 11 0 21 0 11 3 21 4");
    ASSERT_EQ(first.control_points().size(), 3U);
    expect_near(first.control_points()[1], {-2.5, 0});
    const Curve last = curve_of("0 SPLINE 71 3 13 0 23 7 11 0 21 0 11 3 21 4");
    ASSERT_EQ(last.control_points().size(), 3U);
    expect_near(last.control_points()[1], {3, 1.5});
}

TEST(DxfReader, TakesOnlyTheDirectionsOfTangents) {
    const std::string points = "0 SPLINE 71 3 11 0 21 0 11 3 21 4 ";
    const Curve expected = curve_of(points + "12 1 22 2 13 2 23 1");
    EXPECT_EQ(curve_of(points + "12 4e-300 22 8e-300 13 8e300 23 4e300"), expected);
    EXPECT_EQ(curve_of(points + "12 0.25 22 0.5 13 4 23 2"), expected);
}

TEST(DxfReader, GivesOnlyOpenSplinesTangents) {
    const std::string closed = "0 SPLINE 70 1 71 3 11 0 21 0 11 3 21 4 11 0 21 6 11 -3 21 4";
    EXPECT_EQ(curve_of(closed + " 12 1 22 0 13 1 23 0"), curve_of(closed));
    const std::string open = "0 SPLINE 71 3 11 0 21 0 11 3 21 4 11 0 21 6";
    EXPECT_EQ(curve_of(open + " 12 0 22 0 13 0 23 0"), curve_of(open)) << "what has no direction is none";
    EXPECT_NE(curve_of(open + " 12 1 22 0"), curve_of(open));
}

TEST(DxfReader, NeedsTangentsOnlyWhereItUsesThem) {
    const std::string points = " 12 foo 10 0 20 0 10 1 20 1 10 2 20 0";
    EXPECT_EQ(curve_of("0 SPLINE 71 2 40 0 40 0 40 0 40 1 40 1 40 1" + points).control_points().size(), 3U);
    const std::string fit_points = " 11 0 21 0 11 3 21 4 11 0 21 6 11 -3 21 4";
    EXPECT_EQ(curve_of("0 SPLINE 70 1 71 3 13 foo" + fit_points), curve_of("0 SPLINE 70 1 71 3" + fit_points));
    EXPECT_EQ(refusal_of(drawing("0 SPLINE 71 3 12 foo 22 1" + fit_points)),
              "SPLINE at line 6 was left out: line 10 has \"foo\", but it must be a finite number");
}

TEST(DxfReader, FewFitPointsAskForLowDegrees) {
    EXPECT_EQ(curve_of("0 SPLINE 71 3 11 0 21 0 11 1 21 0").degree(), 1);
    EXPECT_EQ(curve_of("0 SPLINE 71 3 11 0 21 0 11 1 21 0 11 2 21 1").degree(), 2);
    EXPECT_EQ(curve_of("0 SPLINE 71 3 12 0 22 1 11 0 21 0 11 1 21 0 11 2 21 1").degree(), 3);
}

TEST(DxfReader, SaysWhereItUsedTangents) {
    const std::string spline = " 0 SPLINE 71 3 12 1 22 0 11 0 21 0 11 3 21 4";
    EXPECT_EQ(read(spline.substr(1)).report.left_out,
              std::vector<std::string>{"SPLINE at line 6 has only points that it passes and tangents at one end or "
                                       "both; a curve with these was made, which may be another between them"});
    EXPECT_EQ(read(spline.substr(1) + spline).report.left_out,
              std::vector<std::string>{
                  "2 entities SPLINE have only points that they pass and tangents at one end or both, the first at "
                  "line 6; curves with these were made, which may be others between them"});
}

TEST(DxfReader, SaysWhichAxisOfAnEllipseHasNoLength) {
    EXPECT_EQ(refusal_of(drawing("0 ELLIPSE 10 1 20 2 11 3 21 0 40 0")),
              "ELLIPSE at line 6 was left out: its second axis has no length, since the ratio of its axes is 0");
    EXPECT_EQ(refusal_of(drawing("0 ELLIPSE 10 1 20 2 11 0 21 0 40 0.5")),
              "ELLIPSE at line 6 was left out: its first axis has no length");
}

TEST(DxfReader, CountsEntitiesOfOneKind) {
    const Imported found = read(
        "0 LINE 10 0 20 0 30 5 11 1 21 1 0 LINE 10 0 20 0 30 5 11 1 21 1 0 LINE 67 1 10 0 20 0 11 1 21 1 "
        "0 LINE 67 1 10 0 20 0 11 1 21 1 0 SPLINE 11 0 21 0 11 1 21 1 0 SPLINE 11 0 21 0 11 1 21 1");
    EXPECT_EQ(found.report.left_out,
              (std::vector<std::string>{
                  "2 entities LINE have heights other than 0, the first at line 6, which were let go",
                  "2 entities LINE were left out, the first at line 30, since they are on sheets of paper, not in the "
                  "model",
                  "2 entities SPLINE have only points that they pass, the first at line 54; curves through them were "
                  "made, which may be others between them"}));
}

TEST(DxfReader, SaysWhatItLeavesOut) {
    const Imported found = read(
        "0 INSERT 2 wheel 10 0 20 0 0 LINE 10 0 20 0 30 5 11 1 21 0 31 5 0 INSERT 2 wheel 0 TEXT 1 hello "
        "0 LINE 67 1 10 0 20 0 11 1 21 1 0 LINE 10 3 20 3 11 3 21 3 0 ARC 40 1 210 1 220 0 230 0 10 0 20 0 "
        "0 LINE 10 nan 20 3 11 3 21 3");
    EXPECT_EQ(found.document.curves.size(), 1U);
    EXPECT_EQ(found.report.left_out,
              (std::vector<std::string>{
                  "2 entities INSERT were left out, the first at line 6; SPLINE, LWPOLYLINE, POLYLINE, LINE, ARC, "
                  "CIRCLE and ELLIPSE are read",
                  "LINE at line 14 has heights other than 0, which were let go",
                  "an entity TEXT at line 32 was left out; SPLINE, LWPOLYLINE, POLYLINE, LINE, ARC, CIRCLE and ELLIPSE "
                  "are read",
                  "LINE at line 36 was left out, since it is on a sheet of paper, not in the model",
                  "LINE at line 48 was left out: point 1 lies on point 0; the two must differ",
                  "ARC at line 58 was left out: its plane is tilted; it must lie in the plane of x and y",
                  "LINE at line 72 was left out: line 74 has \"nan\", but it must be a finite number"}));
    const Imported twice =
        read("0 LINE 10 0 20 0 11 1 21 1 0 CIRCLE 40 -2 10 0 20 0 0 CIRCLE 40 0 10 0 20 0 0 CIRCLE 40 -2 10 3 20 0");
    ASSERT_EQ(twice.report.left_out.size(), 2U) << "each reason";
    EXPECT_TRUE(twice.report.left_out[0].starts_with("2 entities CIRCLE were left out, the first at line 16: "));
    EXPECT_TRUE(twice.report.left_out[1].starts_with("CIRCLE at line 24 was left out: "));
}

TEST(DxfReader, TakesNamesColorsAndUnitsFromTheDrawing) {
    const auto found = read_dxf(
        "0\r\nSECTION\r\n2\r\nHEADER\r\n9\r\n$INSUNITS\r\n70\r\n5\r\n0\r\nENDSEC\r\n"
        "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nhull\n70\n0\n62\n3\n"
        "0\nLAYER\n2\nhidden\n62\n-1\n0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
        "0\nLINE\n8\nhull\n10\n0\n20\n0\n11\n1\n21\n1\n"
        "0\nLINE\n8\nhull\n420\n1193046\n10\n0\n20\n0\n11\n1\n21\n1\n"
        "0\nLINE\n8\nhidden\n10\n0\n20\n0\n11\n1\n21\n1\n"
        "0\nLINE\n8\nM\\U+00e4\xe4\n10\n0\n20\n0\n11\n1\n21\n1\n0\nENDSEC\n0\nEOF\n");
    ASSERT_TRUE(found) << found.error().sentence();
    const auto& curves = found->document.curves;
    ASSERT_EQ(curves.size(), 4U);
    EXPECT_EQ(curves[0].name, "hull");
    EXPECT_EQ(curves[0].color, (core::DocumentColor{0, 255, 0}));
    EXPECT_EQ(curves[1].name, "hull 2");
    EXPECT_EQ(curves[1].color, (core::DocumentColor{0x12, 0x34, 0x56}));
    EXPECT_FALSE(curves[2].visible);
    EXPECT_EQ(curves[3].name, "Mää");
    // A centimeter of the drawing is 10 mm, so that 1 mm is a tenth of it.
    EXPECT_EQ(found->document.units, (core::DocumentUnits{core::LengthUnit::mm, 0.1}));
}

TEST(DxfReader, FindsLayersWhateverTheirCapitals) {
    const auto found = read_dxf(
        "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nWALLs\n70\n0\n62\n-3\n0\nENDTAB\n0\nENDSEC\n"
        "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nwallS\n10\n0\n20\n0\n11\n1\n21\n1\n"
        "0\nLINE\n8\nwall\n10\n0\n20\n0\n11\n1\n21\n1\n0\nENDSEC\n0\nEOF\n");
    ASSERT_TRUE(found) << found.error().sentence();
    const auto& curves = found->document.curves;
    ASSERT_EQ(curves.size(), 2U);
    EXPECT_EQ(curves[0].name, "wallS");
    EXPECT_EQ(curves[0].color, (core::DocumentColor{0, 255, 0}));
    EXPECT_FALSE(curves[0].visible);
    EXPECT_TRUE(curves[1].visible);
}

TEST(DxfReader, RefusesWhatIsNoDrawing) {
    EXPECT_EQ(refusal_of("AutoCAD Binary DXF\r\n\x1a"), "this is a binary DXF; save it as text (ASCII) to read it");
    EXPECT_EQ(refusal_of("AC1027 and so on"), "this is a DWG, not a DXF; save it as DXF to read it");
    EXPECT_EQ(refusal_of("<svg>\n</svg>\n"),
              "line 1: found \"<svg>\", but a group code must be a whole number from -5 to 1071");
    EXPECT_EQ(refusal_of("0\nSECTION\n2\nENTITIES\n0\nENDSEC\n"),
              "line 6: the file ends without its end mark, EOF; it is not whole");
    EXPECT_EQ(refusal_of("0\nSECTION\n2\nENTITIES\n0"),
              "line 5: the file ends after a group code; a value must follow it");
    EXPECT_EQ(refusal_of(std::string_view("0\nSEC\0TION\n2\n", 14)),
              "line 2: there is a zero byte; the file must be text");
    EXPECT_EQ(refusal_of(std::string_view("\x7f"
                                          "ELF\0\1\n",
                                          7)),
              "line 1: there is a zero byte; the file must be text");
    EXPECT_EQ(refusal_of(""), "the file is empty");
    EXPECT_EQ(refusal_of(drawing("999 comment")), "there are no curves in this file");
}

TEST(DxfReader, TakesNumbersBelowTheDoublesForZeros) {
    const auto found = read_dxf(drawing("0 LINE 10 1e-400 20 2 11 -1e-400 21 5"));
    ASSERT_TRUE(found);
    const auto points = found->document.curves.at(0).curve->control_points();
    EXPECT_EQ(points[0], core::Point(0, 2));
    EXPECT_EQ(points[1], core::Point(0, 5));
}

TEST(DxfReader, SurvivesNumbersThatAreTooLarge) {
    for (const char* number : {"1e308", "-1.7e308", "1e999", "inf", "-nan", "1e-320", "--5", ""})
        for (const char* entity :
             {"0 LINE 10 0 20 @ 11 @ 21 1", "0 ARC 10 @ 20 0 40 @ 50 @ 51 90", "0 CIRCLE 10 @ 20 @ 40 @",
              "0 ELLIPSE 10 0 20 0 11 @ 21 @ 40 @ 41 @ 42 @",
              "0 LWPOLYLINE 70 @ 10 0 20 @ 42 @ 10 @ 20 0 42 @ 10 5 20 5",
              "0 SPLINE 70 @ 71 2 40 0 40 0 40 0 40 @ 40 @ 40 @ 10 0 20 @ 10 @ 20 0 10 @ 20 1 41 1 41 @ 41 @",
              "0 SPLINE 70 @ 11 0 21 @ 11 @ 21 0 11 @ 21 1 11 5 21 5",
              "0 SPLINE 71 3 12 @ 22 1 13 1 23 @ 11 0 21 0 11 @ 21 1 11 5 21 5"}) {
            std::string text = entity;
            while (text.find('@') != std::string::npos) text.replace(text.find('@'), 1, number);
            const auto found = read_dxf(drawing(text));
            if (!found) continue;
            for (const core::DocumentCurve& entry : found->document.curves)
                EXPECT_TRUE(core::is_finite(at_share(*entry.curve, 0.4))) << text;
        }
}

TEST(DxfReader, ReadsSoManyCurvesAndNoMore) {
    std::string entities;
    constexpr int count = 120'000;
    for (int i = 0; i < count; ++i) entities += "0 LINE 10 0 20 0 11 1 21 1 ";
    const Imported found = read(entities + "0 TEXT");
    EXPECT_EQ(found.document.curves.size(), 100'000U);
    EXPECT_EQ(found.report.left_out.front(), "20000 curves were left out, since 100000 were read before them");
}

TEST(DxfReader, SaysLittleAboutManyKindsOfEntities) {
    std::string entities = "0 LINE 10 0 20 0 11 1 21 1";
    for (int i = 0; i < 1000; ++i) entities += " 0 ENTITY" + std::to_string(i);
    const Imported found = read(entities);
    ASSERT_EQ(found.report.left_out.size(), 41U);
    EXPECT_EQ(found.report.left_out.back(), "there are 960 more things to tell, of other kinds");
}

}  // namespace batten::exchange
