#include "core/document/point_table.h"

#include <gtest/gtest.h>

namespace batten::core {
namespace {

using Points = std::vector<Point>;

PointTable table_of(std::string_view text, std::optional<TableColumns> columns = std::nullopt) {
    const auto table = read_point_table(text, columns);
    EXPECT_TRUE(table) << (table ? "" : table.error().sentence());
    return table.value_or(PointTable{});
}

std::string refusal_of_table(std::string_view text, std::optional<TableColumns> columns = std::nullopt) {
    const auto table = read_point_table(text, columns);
    return table ? "" : table.error().sentence();
}

TEST(PointTable, the_whole_table_decides_what_commas_are) {
    const Points half{{1.5, 2.5}, {3.0, -4.25}};
    for (const char* text :
         {"1.5\t2.5\n3\t-4.25\n", "1.5,2.5\n3,-4.25", "1.5;2.5\n3;-4.25", "1.5 2.5\n3 -4.25", "1,5\t2,5\n3\t-4,25",
          "1,5;2,5\n3;-4,25", "1,5 2,5\n3,0 -4,25", "\"1,5\",\"2,5\"\n3,\"-4,25\"", "  1.5,   2.5\n  3,  -4.25  \n"})
        EXPECT_EQ(table_of(text).points, half) << text;
    // Without a decimal there is nothing to tell: the comma separates.
    EXPECT_EQ(table_of("1,5\n3,4\n").points, (Points{{1, 5}, {3, 4}}));
    EXPECT_EQ(table_of("1,5;2\n3;4\n").points, (Points{{1.5, 2}, {3, 4}}));
}

TEST(PointTable, tells_how_it_was_read) {
    const PointTable table = table_of("x;y\n1,5;2,5\n3;4\n");
    EXPECT_EQ(table.separator, TableSeparator::semicolon);
    EXPECT_TRUE(table.has_decimal_commas);
    EXPECT_EQ(table.headings, (std::vector<std::string>{"x", "y"}));
    EXPECT_EQ(table.column_count, 2U);
    EXPECT_EQ(table_of("1 2\n3 4").separator, TableSeparator::blank);
    EXPECT_FALSE(table_of("1 2\n3 4").has_decimal_commas);
}

TEST(PointTable, takes_what_spreadsheets_and_systems_add) {
    const Points points{{1, -2}, {3, 4}};
    EXPECT_EQ(table_of("\xEF\xBB\xBFx\ty\r\n1\t\xE2\x88\x92"
                       "2\r\n3\t4\r\n\r\n")
                  .points,
              points);
    EXPECT_EQ(table_of("1\t-2\r3\t4\r").points, points);
    EXPECT_EQ(table_of("1;-2;;\n;;;\n3;4;;\n").points, points);
    EXPECT_EQ(table_of("# made by hand\n1 -2 # first\n3\xC2\xA0"
                       "4\n")
                  .points,
              points);
    EXPECT_EQ(table_of("1e0,-2E+0\n+3,4.\n").points, points);
}

TEST(PointTable, chooses_columns) {
    const char* stations = "station\tx\ty\tz\nA\t1\t2\t3\nB\t4\t5\t6\n";
    EXPECT_EQ(table_of(stations).points, (Points{{1, 2}, {4, 5}}));
    EXPECT_EQ(table_of(stations).columns.x, 2U);
    EXPECT_EQ(table_of(stations, TableColumns{4, 2}).points, (Points{{3, 1}, {6, 4}}));
    // Headings say which are x and y, whatever stands before them.
    EXPECT_EQ(table_of("station,Y,X\n1,2,3\n4,5,6\n").points, (Points{{3, 2}, {6, 5}}));
    EXPECT_EQ(table_of("station,y,z\n1,2,3\n4,5,6\n").points, (Points{{1, 2}, {4, 5}}));
    // A column that is empty in front stays one.
    EXPECT_EQ(table_of("\tx\ty\n\t1\t2\n\t3\t4\n").points, (Points{{1, 2}, {3, 4}}));
}

TEST(PointTable, reads_an_airfoil_around) {
    const PointTable table = table_of("NACA 2412\n 1.0 0.0013\n 0.5  0.0724\n 0.0 0.0\n 0.5 -0.0424\n 1.0 -0.0013\n");
    EXPECT_EQ(table.title, "NACA 2412");
    EXPECT_EQ(table.points, (Points{{1, 0.0013}, {0.5, 0.0724}, {0, 0}, {0.5, -0.0424}, {1, -0.0013}}));
    EXPECT_FALSE(table.is_two_sided);
    // Its name may look like a line of the table.
    EXPECT_EQ(table_of("NACA 23 012\n1 0\n0 0\n1 0\n").points.size(), 3U);
    EXPECT_EQ(table_of("20-32C AIRFOIL\n1 0\n0 0\n1 0\n").title, "20-32C AIRFOIL");
}

TEST(PointTable, joins_the_two_sides_of_an_airfoil) {
    const PointTable table =
        table_of("CLARK Y\n 3. 3.\n\n 0.0 0.0\n 0.5 0.09\n 1.0 0.001\n\n 0.0 0.0\n 0.5 -0.03\n 1.0 -0.001\n");
    EXPECT_TRUE(table.is_two_sided);
    EXPECT_EQ(table.title, "CLARK Y");
    EXPECT_EQ(table.points, (Points{{1, 0.001}, {0.5, 0.09}, {0, 0}, {0.5, -0.03}, {1, -0.001}}));
    // Numbers that do not count the lines below are a point.
    EXPECT_EQ(table_of("3 3\n0 0\n1 1\n").points.size(), 3U);
}

TEST(PointTable, errors_name_line_and_column) {
    EXPECT_EQ(refusal_of_table("x,y\n1,2\n3,abc\n"),
              "line 3, column 2: 'abc' is not a finite number; this table has decimal points");
    EXPECT_EQ(refusal_of_table("1;2,5\n\n1,5;2.5\n3,5;4,5"),
              "line 3, column 2: '2.5' is not a finite number; this table has decimal commas");
    EXPECT_EQ(refusal_of_table("1\t2\n\t4\n5\t6\n"), "line 2, column 1: the cell is empty; a number is needed");
    EXPECT_EQ(refusal_of_table("1,2\n3\n4,5\n"), "line 2, column 2: the line has one column");
    EXPECT_EQ(refusal_of_table("1,2\n3,4\n", TableColumns{1, 5}), "line 1, column 5: the line has 2 columns");
    EXPECT_EQ(refusal_of_table("1,2\n3,inf\n"),
              "line 2, column 2: 'inf' is not a finite number; this table has decimal points");
    EXPECT_EQ(refusal_of_table("1,2\n3,1e999\n"),
              "line 2, column 2: '1e999' is not a finite number; this table has decimal points");
    const char* none = "no line with two numbers was found; a table of points has x and y in two of its columns";
    for (const char* text : {"", "\n\n", "x,y\n", "only words\nhere too\n"})
        EXPECT_EQ(read_point_table(text).error().what, none) << text;
    EXPECT_NE(read_point_table("\xFF\xFE"
                               "1")
                  .error()
                  .what.find("UTF-16"),
              std::string::npos);
}

TEST(PointTable, takes_numbers_below_the_doubles_for_zeros) {
    EXPECT_EQ(table_of("1e-400,2\n3,-1e-400\n").points, (Points{{0, 2}, {3, 0}}));
}

TEST(PointTable, a_first_line_with_a_slip_is_no_heading) {
    EXPECT_EQ(refusal_of_table("1.5,abc\n1,2\n3,4\n"),
              "line 1, column 2: 'abc' is not a finite number; this table has decimal points");
}

// As `batten convert -o wave.csv` writes a knot at which a derivative jumps, and a tear, where the curve does.
TEST(PointTable, takes_two_rows_of_one_place_for_one_point) {
    const std::string heading = "curve,u,x,y,x',y'\n";
    const std::vector<Point> expected{{0, 0}, {1, 2}, {3, 0}, {4, 4}};
    EXPECT_EQ(table_of(heading + "a,0,0,0,1,1\na,0.5,1,2,1,0\na,0.5,1,2,0,1\na,1,3,0,1,1\na,1,4,4,1,1\n").points,
              expected);
    EXPECT_EQ(table_of("t,v,x,y\na,0,1,1\na,0,1,1\n").points.size(), 2U) << "rows of something else";
    EXPECT_EQ(table_of("u,x,y\n0,1,1\n1,1,1\n").points.size(), 2U) << "two places";
}

TEST(PointTable, reads_a_hundred_thousand_rows) {
    std::string text = "t;x;y\n";
    for (int i = 0; i < 100000; ++i) text += std::to_string(i) + ";0," + std::to_string(i) + ";7\n";
    const PointTable table = table_of(text, TableColumns{2, 1});
    ASSERT_EQ(table.points.size(), 100000U);
    EXPECT_EQ(table.points[25], Point(0.25, 25));
    EXPECT_EQ(table.points.back(), Point(0.99999, 99999));
}

}  // namespace
}  // namespace batten::core
