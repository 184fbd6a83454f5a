#include "core/document/point_table.h"

#include <gtest/gtest.h>

#include <array>

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

// As programs write what is no number, in a first row that would pass for headings.
TEST(PointTable, a_first_line_without_numbers_in_their_places_is_no_heading) {
    const std::vector<std::pair<const char*, const char*>> lines{
        {"nan,nan", "line 1, column 1: 'nan'"},           {"NaN\t1", "line 1, column 1: 'NaN'"},
        {"inf inf", "line 1, column 1: 'inf'"},           {"-Infinity;2", "line 1, column 1: '-Infinity'"},
        {"n/a,n/a", "line 1, column 1: 'n/a'"},           {"NA 1", "line 1, column 1: 'NA'"},
        {"#N/A,#N/A", "line 1, column 1: '#N/A'"},        {"1;#DIV/0!", "line 1, column 2: '#DIV/0!'"},
        {"#REF!\t#VALUE!", "line 1, column 1: '#REF!'"},  {"1.#INF 2", "line 1, column 1: '1.#INF'"},
        {"1.#QNAN00,2", "line 1, column 1: '1.#QNAN00'"}, {"nan(ind) 2", "line 1, column 1: 'nan(ind)'"}};
    for (const auto& [line, place] : lines) {
        const char separator = line[std::string_view(line).find_first_of(",;\t ")];
        const std::string rest = std::string("\n1") + separator + "2\n3" + separator + "4\n";
        EXPECT_EQ(refusal_of_table(line + rest),
                  std::string(place) + " is not a finite number; this table has decimal points");
    }
}

// Sodium, as its content stands in a table, and what else reads like a value that is none.
TEST(PointTable, names_of_columns_may_read_like_no_number) {
    for (const char* text : {"x,y,Na\n1,2,3\n4,5,6", "x\ty\tInf\n1\t2\t3\n4\t5\t6", "NA\tx\ty\n0\t1\t2\n0\t4\t5",
                             "x y nan\n1 2 3\n4 5 6", "K;Na\n1;2\n4;5"})
        EXPECT_EQ(table_of(text).points, (Points{{1, 2}, {4, 5}})) << text;
    EXPECT_EQ(table_of("K;Na\n1;2").headings, (std::vector<std::string>{"K", "Na"}));
    EXPECT_NE(refusal_of_table("nan,2\n1,2\n"), "");
}

TEST(PointTable, lines_above_the_names_of_columns_are_headings) {
    const Points points{{1, 2}, {3, 4}, {5, 6}};
    for (const char* text : {"Points,3\nx,y\n1,2\n3,4\n5,6", "3\nX;Y\n1;2\n3;4\n5;6",
                             "Date,2026,11,27\nx,y\n1,2\n3,4\n5,6", "Wing\nChord\t1.5\nx\ty\nmm\tmm\n1\t2\n3\t4\n5\t6"})
        EXPECT_EQ(table_of(text).points, points) << text;
    // Rows of numbers are no headings.
    EXPECT_EQ(refusal_of_table("A,1,2\nB,3,4\nx,y,z\n4,5,6\n"),
              "line 3, column 2: 'y' is not a finite number; this table has decimal points");
    EXPECT_EQ(refusal_of_table("1,2\nx,y\n3,4\n"),
              "line 2, column 1: 'x' is not a finite number; this table has decimal points");
}

TEST(PointTable, a_name_above_numbers_alone_is_refused) {
    const std::string refusal =
        " stands above numbers, and may name its column or its point; a line with x and y above the numbers tells "
        "which columns are read";
    EXPECT_EQ(refusal_of_table("time,2024,2025\n1,2,3\n4,5,6"), "line 1, column 1: 'time'" + refusal);
    EXPECT_EQ(refusal_of_table("Origin\t0\t0\n1\t10\t5"), "line 1, column 1: 'Origin'" + refusal);
    EXPECT_EQ(table_of("point,x,y\nOrigin,0,0\n1,10,5").points, (Points{{0, 0}, {10, 5}}));
    EXPECT_EQ(refusal_of_table("O.5,1\n2,3\n"),
              "line 1, column 1: 'O.5' is not a finite number; this table has decimal points");
    EXPECT_EQ(table_of("Origin,0,0\nA,10,5").points, (Points{{0, 0}, {10, 5}}));
}

TEST(PointTable, comments_may_hold_what_looks_like_an_error) {
    EXPECT_EQ(table_of("#index x y\n# inf\n1 2 # nan\n3 4\n").points, (Points{{1, 2}, {3, 4}}));
    EXPECT_EQ(table_of("\"a#1\",1,2\n\"b#2\",3,4\n").points, (Points{{1, 2}, {3, 4}})) << "a name that is quoted";
}

TEST(PointTable, thousands_separators_are_refused_with_their_place) {
    for (const char* cell : {"1,234,567", "1.234.567", "1,234.5", "1.234,5", "-12,345,678.9", "1 234,5", "1 234.5",
                             "1\xE2\x80\xAF"
                             "234",
                             "1'234.5", "1,23,456.7"}) {
        std::string plain = cell;
        if (const auto at = plain.find("\xE2\x80\xAF"); at != std::string::npos) plain.replace(at, 3, " ");
        const std::string refusal = ": '" + plain + "' has thousands separators, which are not read";
        for (const char separator : {'\t', ';'}) {
            EXPECT_EQ(refusal_of_table(cell + std::string(1, separator) + "2\n"), "line 1, column 1" + refusal);
            EXPECT_EQ(
                refusal_of_table("x" + std::string(1, separator) + "y\n3" + separator + "4\n5" + separator + cell),
                "line 3, column 2" + refusal);
        }
        const bool may_be_two = plain.find(' ') != std::string::npos;
        EXPECT_EQ(refusal_of_table("2,\"" + std::string(cell) + "\"\n"),
                  may_be_two ? "line 1, column 2: '" + plain +
                                   "' is more than one number or has thousands separators; each point needs a line, "
                                   "with a comma between x and y"
                             : "line 1, column 2" + refusal);
    }
}

TEST(PointTable, cells_of_several_numbers_are_refused_with_their_place) {
    const std::vector<std::array<const char*, 3>> tables{
        {"1\t1.5,5\n2\t2.5,6", "line 1, column 2", "1.5,5"},
        {"\"1,234.5,678.9\",2", "line 1, column 1", "1,234.5,678.9"},
        {"1,5.3;2", "line 1, column 1", "1,5.3"},
        {"1,2\n3,4 5,6", "line 2, column 2", "4 5"},
        {"1.5,2.5 3.5,4.5\n5.5,6.5 7.5,8.5", "line 1, column 2", "2.5 3.5"},
        {"1.5 2.5,3.5 4.5", "line 1, column 2", "2.5,3.5"},
        {"1.5,2.5;3.5,4.5", "line 1, column 2", "2.5;3.5"},
        {"a,2.5 3.5,4.5 5.5\nb,2,3", "line 1, column 2", "2.5 3.5"}};
    for (const auto& [text, place, cell] : tables)
        EXPECT_EQ(refusal_of_table(text), place + std::string(": '") + cell +
                                              "' is more than one number; each point needs a line, with one separator "
                                              "between its columns");
    // As SVG has pairs, where the blank may separate thousands.
    EXPECT_EQ(refusal_of_table("100,200 300,400"),
              "line 1, column 2: '200 300' is more than one number or has thousands separators; each point needs a "
              "line, with a comma between x and y");
    EXPECT_EQ(table_of("x,y,parts\n1,2,3.5 4.5\n").points, (Points{{1, 2}})) << "in a column that is not read";
}

TEST(PointTable, three_digits_behind_a_comma_may_be_thousands) {
    const char* refusal =
        ": '1,234' may have a decimal comma or separate thousands by it; semicolons between the columns tell that "
        "commas are decimal";
    for (const char* text : {"1,234\t5,678\n", "1,234 5,678\n", "\"1,234\",\"5,678\"\n", "1,234\t0.5\n", "1,234\t7\n"})
        EXPECT_EQ(refusal_of_table(text), "line 1, column 1" + std::string(refusal)) << text;
    // Semicolons stand where commas are decimal; and one number that can have no thousands tells for all.
    EXPECT_EQ(table_of("1,234;5,678\n").points, (Points{{1.234, 5.678}}));
    for (const char* text : {"1,234\t5,678\n0,250\t2\n", "1,234 5,678\n0,250 2\n", "1,234\t5,678\n,25\t2,0\n"})
        EXPECT_EQ(table_of(text).points, (Points{{1.234, 5.678}, {0.25, 2}})) << text;
    EXPECT_EQ(table_of("1.234;5.678\n").points, (Points{{1.234, 5.678}})) << "points are decimal";
}

TEST(PointTable, rows_that_commas_cut_in_more_cells_are_refused) {
    EXPECT_EQ(refusal_of_table("x,y\n1,234,567\n"),
              "line 2, column 3: the line has 3 columns, and there are 2 headings");
    EXPECT_EQ(refusal_of_table("Length,Height\n1,234,567\n2,345,678\n"),
              "line 2, column 3: the line has 3 columns, and there are 2 headings");
    EXPECT_EQ(refusal_of_table("998,1\n999,2\n1,000,3\n"),
              "line 3, column 3: the line has 3 columns, and the first one has 2");
    EXPECT_EQ(refusal_of_table("1,000,3\n999,2\n"),
              "line 2, column 3: the line has 2 columns, and the first one has 3");
    EXPECT_EQ(refusal_of_table("998 1\n1 000 3\n"),
              "line 2, column 3: the line has 3 columns, and the first one has 2");
    // Cells may be empty at the end, and remarks stand anywhere.
    const Points points{{1, 2}, {3, 4}};
    for (const char* text :
         {"1,2,\n3,4,5\n", "1,2,5\n3,4,\n", "1,2,start\n3,4\n", "x,y,z\n1,2,5\n3,4\n", "1 2\n3 4 end\n"})
        EXPECT_EQ(table_of(text).points, points) << text;
}

// As write.table of R writes it, where nothing stands above the names of the rows.
TEST(PointTable, a_row_longer_than_its_headings_is_refused) {
    EXPECT_EQ(refusal_of_table("\"x\" \"y\"\n\"1\" 0.5 2\n\"2\" 1 3\n"),
              "line 2, column 3: the line has 3 columns, and there are 2 headings");
    EXPECT_EQ(table_of("\"x\" \"y\"\n\"1\" 0.5 2\n\"2\" 1 3\n", TableColumns{2, 3}).points, (Points{{0.5, 2}, {1, 3}}));
}

TEST(PointTable, units_below_the_names_of_columns_change_nothing) {
    EXPECT_EQ(table_of("t,x,y\n[s],[mm],[mm]\n0,1,2\n1,3,4\n").points, (Points{{1, 2}, {3, 4}}));
}

TEST(PointTable, of_several_curves_the_first_is_read_and_the_others_are_told) {
    const std::string first = "curve,u,x,y\na,0,1,2\na,1,3,4\n";
    EXPECT_EQ(told_of_other_curves(table_of(first)), "");
    const PointTable two = table_of(first + "b,0,5,6\nb,0.5,5,7\nb,1,7,8\n");
    EXPECT_EQ(two.points, (Points{{1, 2}, {3, 4}}));
    EXPECT_EQ(told_of_other_curves(two),
              "the points are those of the first curve; the rows of another one are left out: 3");
    const PointTable three = table_of(first + "b,0,5,6\nb,1,7,8\nc,0,1,1\n");
    EXPECT_EQ(three.points, (Points{{1, 2}, {3, 4}}));
    EXPECT_EQ(told_of_other_curves(three),
              "the points are those of the first curve; the rows of 2 others are left out: 3");
    // Two curves may have one name, or none.
    for (const char* name : {"a", "\"a\""})
        EXPECT_EQ(table_of(first + name + ",0,5,6\n" + name + ",1,7,8\n").points, two.points);
    // A name that is not repeated goes on, unless u begins anew.
    for (const char* text : {"curve,x,y\na,1,2\n,3,4\nb,5,6\n,5,7\n", "curve,u,x,y\na,0,1,2\n,1,3,4\nb,0,5,6\n,1,5,7\n",
                             "curve,u,x,y\na,0,1,2\n,1,3,4\n,0,5,6\n,1,5,7\n"}) {
        const PointTable table = table_of(text);
        EXPECT_EQ(table.points, two.points) << text;
        EXPECT_EQ(table.other_curves, 1U) << text;
        EXPECT_EQ(table.other_rows, 2U) << text;
    }
    const PointTable nameless = table_of("Curve;U;X;Y\n;0;1;2\n;1;3;4\n;0;5;6\n");
    EXPECT_EQ(nameless.points, two.points);
    EXPECT_EQ(nameless.other_rows, 1U);
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
