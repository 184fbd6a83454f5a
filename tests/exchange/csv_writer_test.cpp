#include "exchange/csv_writer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/document/point_table.h"
#include "core/make/conics.h"
#include "tests/exchange/carried_curves.h"

namespace batten::exchange {

namespace {

using core::Curve;

std::string table_of(const core::Document& document, std::size_t samples) {
    const auto written = write_csv(document, {.samples = samples});
    EXPECT_TRUE(written);
    return written->text;
}

}  // namespace

TEST(CsvWriter, WritesPointsDerivativesAndCurvature) {
    // C(u) = (3u, 2u^2): C' = (3, 4u), C'' = (0, 4), curvature 12 / |C'|^3, of which 12 / 125 is at 1.
    const Curve parabola =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1.5, 0}, {3, 2}}}).value();
    const std::string table = table_of(document_of(parabola), 3);
    EXPECT_TRUE(table.starts_with("curve,u,x,y,x',y',x'',y'',curvature\nwave,0,0,0,3,0,0,4,0.4444")) << table;
    EXPECT_NE(table.find("\nwave,0.5,1.5,0.5,3,2,0,4,0.256"), std::string::npos) << table;
    EXPECT_TRUE(table.ends_with("\nwave,1,3,2,3,4,0,4,0.096\n")) << table;
}

TEST(CsvWriter, SeesKnotsOfLittleContinuityFromBothSides) {
    const Curve corner =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {2, 0}, {2, 3}}}).value();
    EXPECT_EQ(table_of(document_of(corner, "a,\"b\""), 3),
              "curve,u,x,y,x',y',x'',y'',curvature\n"
              "\"a,\"\"b\"\"\",0,0,0,2,0,0,0,0\n"
              "\"a,\"\"b\"\"\",1,2,0,2,0,0,0,0\n"
              "\"a,\"\"b\"\"\",1,2,0,0,3,0,0,0\n"
              "\"a,\"\"b\"\"\",2,2,3,0,3,0,0,0\n");
}

TEST(CsvWriter, LeavesCellsEmptyWhereThereIsNoNumber) {
    // It stands still at its beginning, where it has no curvature.
    const Curve still =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 1}, {1, 1}, {2, 5}}}).value();
    const std::string table = table_of(document_of(still), 2);
    EXPECT_NE(table.find("wave,0,1,1,0,0,2,8,\n"), std::string::npos) << table;
}

TEST(CsvWriter, WritesTablesOfWhichTheFirstCurveReadsBackAsPoints) {
    const std::vector<CarriedCurve> curves{{"circle", core::circle({1e6, 2}, 3).value()},
                                           {"arc", core::circular_arc({0, 0}, 2, {0, 90}).value()}};
    const auto table = core::read_point_table(table_of(document_of(curves), 11));
    ASSERT_TRUE(table) << table.error().sentence();
    // The circle has jumps of its second derivative at three knots inside, each with two rows that are one point; none
    // of them is among the samples at tenths but that at 1/2.
    ASSERT_EQ(table->points.size(), 11U + 2U);
    for (std::size_t i = 0; i < 13; ++i) EXPECT_NEAR(core::distance(table->points[i], {1e6, 2}), 3.0, 1e-9);
    for (std::size_t i = 1; i < 13; ++i) EXPECT_GT(core::distance(table->points[i - 1], table->points[i]), 0.1);
    EXPECT_EQ(table->points[0], (core::Point{1e6 + 3, 2}));
    EXPECT_EQ(table->other_rows, 11U);
    EXPECT_EQ(core::told_of_other_curves(*table),
              "the points are those of the first curve; the rows of another one are left out: 11");
}

TEST(CsvWriter, WritesNothingThatIsNoNumber) {
    for (const CarriedCurve& curve : carried_curves(20)) {
        const std::string table = table_of(document_of(curve.curve, "c"), 7);
        const std::string rows = table.substr(table.find('\n'));
        EXPECT_EQ(rows.find("nan"), std::string::npos) << curve.name;
        EXPECT_EQ(rows.find("inf"), std::string::npos) << curve.name;
    }
}

}  // namespace batten::exchange
