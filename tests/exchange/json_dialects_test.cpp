#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "core/evaluate/evaluate.h"
#include "exchange/json/json_dialects_reader.h"
#include "exchange/json/json_dialects_writer.h"
#include "exchange/json/json_tree.h"
#include "tests/exchange/carried_curves.h"

namespace batten::exchange {

namespace {

using core::Curve;
using core::Point;

// The one curve in `text`.
Curve curve_in(Reader read, std::string_view text) {
    const auto found = read(text);
    EXPECT_TRUE(found) << found.error().sentence();
    EXPECT_EQ(found->document.curves.size(), 1U);
    return *found->document.curves.at(0).curve;
}

std::string refusal_by(Reader read, std::string_view text) {
    const auto found = read(text);
    return found ? "" : found.error().sentence();
}

void expect_near(Point found, Point expected) {
    EXPECT_NEAR(found.x, expected.x, 1e-15);
    EXPECT_NEAR(found.y, expected.y, 1e-15);
}

// The least time that reading `objects` objects of `members` members takes, whose names differ at their ends.
double seconds_of_objects(std::size_t objects, std::size_t members) {
    std::string object;
    for (std::size_t i = 0; i < members; ++i) object += (i == 0 ? "{\"" : ",\"") + std::to_string(10'000 + i) + "\":0";
    std::string text = "[0";
    for (std::size_t i = 0; i < objects; ++i) text += ",[" + object + "}]";
    text += "]";
    double least = INFINITY;
    for (int k = 0; k < 3; ++k) {
        const auto start = std::chrono::steady_clock::now();
        EXPECT_TRUE(parse_json_tree(text));
        least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return least;
}

}  // namespace

TEST(NurbsPython, ReadsWhatTheLibraryWrites) {
    const auto found = read_nurbs_python(R"({"shape": {"type": "curve", "count": 7, "data": [
        {"type": "spline", "rational": true, "dimension": 3, "degree": 2, "knotvector": [0, 0, 0, 1, 1, 1],
         "control_points": {"points": [[1, 0, 0], [1, 1, 0.5], [0, 1, 0]], "weights": [1, 2, 1]}, "delta": 0.01},
        {"type": "spline", "rational": false, "degree": 1, "knotvector": [0, 0, 1, 1], "name": "edge",
         "control_points": {"points": [[1, 0], [1, 1]], "weights": null}}]}})");
    ASSERT_TRUE(found) << found.error().sentence();
    ASSERT_EQ(found->document.curves.size(), 2U);
    // (1, 0) + 2 * 2 * (1, 1) + (0, 1) over 1 + 4 + 1.
    expect_near(core::point_at(*found->document.curves[0].curve, 0.5), {5.0 / 6.0, 5.0 / 6.0});
    EXPECT_EQ(found->document.curves[1].name, "edge");
    EXPECT_FALSE(found->document.curves[1].curve->is_rational());
    EXPECT_EQ(found->report.left_out,
              std::vector<std::string>{"the curve at /shape/data/0 has heights other than 0, which were let go"});
}

TEST(NurbsPython, WritesWhatTheLibraryReads) {
    const Curve curve =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0.5}, {1, 1}}, .weights = {1, 3}}).value();
    const auto written = write_nurbs_python(document_of(curve, "a \"b\""), {});
    ASSERT_TRUE(written);
    EXPECT_EQ(written->text, R"({"shape": {
  "type": "curve",
  "count": 1,
  "data": [{
    "type": "spline",
    "rational": true,
    "dimension": 2,
    "name": "a \"b\"",
    "degree": 1,
    "knotvector": [0,0,1,1],
    "control_points": {"points": [[0,0.5],[1,1]], "weights": [1,3]},
    "delta": 0.01
  }]
}}
)");
}

TEST(NurbsPython, NamesBothConventionsWhereKnotsAreMissing) {
    EXPECT_EQ(
        refusal_by(read_nurbs_python,
                   R"({"shape": {"data": {"degree": 2, "knotvector": [0, 0, 1, 1],
                             "control_points": {"points": [[1, 0], [1, 1], [0, 1]]}}}})"),
        "the curve at /shape/data was left out: the number of knots is 4; for 3 control points of degree 2 it must be "
        "6, points + degree + 1, while 4, points + degree − 1, is Rhino-style");
}

TEST(Tinyspline, ReadsPlanePointsAndSpacePoints) {
    const Curve plane = curve_in(
        read_tinyspline, R"({"degree": 1, "dimension": 2, "control_points": [0, 0, 2, 4], "knots": [0, 0, 1, 1]})");
    EXPECT_EQ(core::point_at(plane, 0.5), (Point{1, 2}));
    // Without a word about weights the third number is a height.
    const auto space = read_tinyspline(
        R"({"degree": 1, "dimension": 3, "control_points": [0, 0, 1, 2, 4, 2], "knots": [0, 0, 1, 1]})");
    ASSERT_TRUE(space);
    EXPECT_FALSE(space->document.curves[0].curve->is_rational());
    EXPECT_EQ(space->report.left_out.size(), 1U);
}

TEST(Tinyspline, ReadsHomogeneousPointsThatAreNamedSo) {
    const Curve curve = curve_in(read_tinyspline, R"({"degree": 2, "dimension": 3, "homogeneous": true,
        "control_points": [1, 0, 1, 2, 2, 2, 0, 1, 1], "knots": [0, 0, 0, 1, 1, 1]})");
    EXPECT_EQ(curve.control_points()[1], (Point{1, 1}));
    EXPECT_EQ(curve.weights()[1], 2.0);
    expect_near(core::point_at(curve, 0.5), {5.0 / 6.0, 5.0 / 6.0});
    EXPECT_EQ(refusal_by(read_tinyspline, R"({"degree": 1, "dimension": 3, "homogeneous": true,
        "control_points": [1, 0, 1, 2, 2, 0], "knots": [0, 0, 1, 1]})")
                  .find("NaN"),
              std::string::npos);
}

TEST(Tinyspline, WritesHomogeneousPointsByName) {
    const Curve curve =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{3, 4}, {5, 6}}, .weights = {1, 2}}).value();
    const auto written = write_tinyspline(document_of(curve), {});
    ASSERT_TRUE(written);
    EXPECT_EQ(written->text, R"({
    "name": "wave",
    "degree": 1,
    "dimension": 3,
    "homogeneous": true,
    "control_points": [3,4,1,10,12,2],
    "knots": [0,0,1,1]
  }
)");
    EXPECT_EQ(written->report.largest_error, 0.0);
}

TEST(Tinyspline, TellsTheRoundingOfProducts) {
    const Curve curve =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0.1, 0}, {1, 0}}, .weights = {0.3, 1}}).value();
    const auto written = write_tinyspline(document_of(curve), {});
    ASSERT_TRUE(written);
    EXPECT_GT(written->report.largest_error, 0.0);
    EXPECT_LE(written->report.largest_error, 0.1 * 0x1p-53);
}

// 0.3 times the least double is none; the weights mean the same a power of two larger.
TEST(Tinyspline, TinyAndHugeWeightsKeepThePoints) {
    for (const double size : {0x1p-1074, 1e-200, 0x1p1022}) {
        SCOPED_TRACE(size);
        const std::vector<Point> points{{0.3, 0.1}, {1.3, 1}, {2.7, 1e-200}};
        const Curve curve =
            Curve::make(
                {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = points, .weights = {size, 2 * size, 2 * size}})
                .value();
        const auto written = write_tinyspline(document_of(curve), {});
        ASSERT_TRUE(written);
        EXPECT_LE(written->report.largest_error, 1e-15);
        const Curve copy = curve_in(read_tinyspline, written->text);
        for (std::size_t i = 0; i < 3; ++i) {
            expect_near(copy.control_points()[i], points[i]);
            EXPECT_EQ(copy.weights()[i] / copy.weights()[0], i == 0 ? 1.0 : 2.0);
        }
    }
}

// A weight too small to be scaled beside one too large: the first product is 0, and the point comes back as (0, 0).
TEST(Tinyspline, TellsWhatTinyProductsLose) {
    const Curve curve =
        Curve::make(
            {.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0.3, 0}, {0.5, 0}}, .weights = {0x1p-1074, 0x1p100}})
            .value();
    const auto written = write_tinyspline(document_of(curve), {});
    ASSERT_TRUE(written);
    EXPECT_NEAR(written->report.largest_error, 0.3, 1e-15);
    const auto lost = read_tinyspline(R"({"degree": 1, "dimension": 3, "homogeneous": true,
        "control_points": [1e-323, 0, 7, 1, 0, 1], "knots": [0, 0, 1, 1]})");
    ASSERT_TRUE(lost);
    EXPECT_GT(lost->report.largest_error, 0.0);
}

TEST(Rhino, ReadsKnotsWithoutTheEnds) {
    const double w = std::sqrt(0.5);
    const Curve quarter = curve_in(read_rhino, R"({"curves": [{"degree": 2, "points": [[1, 0], [1, 1], [0, 1]],
        "weights": [1, 0.7071067811865476, 1], "knots": [0, 0, 1, 1]}]})");
    EXPECT_EQ(std::vector(quarter.knots().values().begin(), quarter.knots().values().end()),
              (std::vector<double>{0, 0, 0, 1, 1, 1}));
    expect_near(core::point_at(quarter, 0.5), {w, w});
}

TEST(Rhino, RepeatsTheEndsOfUnclampedCurvesAndSaysSo) {
    // The uniform cubic with knots -3..4: C(0) = (P0 + 4 P1 + P2) / 6.
    const auto found = read_rhino(R"({"curves": [{"degree": 3, "points": [[0, 0], [6, 0], [6, 6], [0, 6]],
        "knots": [-2, -1, 0, 1, 2, 3]}]})");
    ASSERT_TRUE(found) << found.error().sentence();
    const Curve& curve = *found->document.curves[0].curve;
    EXPECT_EQ(curve.domain().lower, 0.0);
    EXPECT_EQ(curve.domain().upper, 1.0);
    expect_near(core::point_at(curve, 0.0), {5, 1});
    expect_near(core::point_at(curve, 1.0), {5, 5});
    EXPECT_EQ(found->report.left_out,
              std::vector<std::string>{"the first and the last knot of the curve at /curves/0, which the file does not "
                                       "have and the curve does not depend on, were made equal to their neighbors"});
}

TEST(Rhino, NamesBothConventionsWhereThereAreTooManyKnots) {
    EXPECT_EQ(refusal_by(read_rhino, R"({"curves": [{"degree": 2, "points": [[1, 0], [1, 1], [0, 1]],
        "knots": [0, 0, 0, 1, 1, 1]}]})"),
              "the curve at /curves/0 was left out: the number of knots is 6; for 3 control points of degree 2 "
              "Rhino-style has 4, points + degree − 1, while other formats have 6, points + degree + 1");
}

TEST(Rhino, WritesKnotsWithoutTheEnds) {
    const Curve curve =
        Curve::make({.degree = 2, .knots = {-3, 0, 0, 1, 1, 9}, .points = {{3, 4}, {5, 6}, {7, 7}}}).value();
    const auto written = write_rhino(document_of(curve), {});
    ASSERT_TRUE(written);
    EXPECT_NE(written->text.find("\"knots\": [0,0,1,1]\n"), std::string::npos) << written->text;
}

TEST(OpenCascade, ReadsMultiplicities) {
    const Curve curve =
        curve_in(read_opencascade, R"({"curves": {"degree": 2, "poles": [[0, 0], [2, 0], [2, 2], [4, 4]],
        "knots": [0, 0.5, 1], "multiplicities": [3, 1, 3]}})");
    EXPECT_EQ(std::vector(curve.knots().values().begin(), curve.knots().values().end()),
              (std::vector<double>{0, 0, 0, 0.5, 1, 1, 1}));
    expect_near(core::point_at(curve, 0.5), {2, 1});
}

TEST(OpenCascade, RefusesWhatDoesNotFit) {
    const auto with = [](const std::string& members) {
        return refusal_by(read_opencascade,
                          R"({"curves": [{"degree": 2, "poles": [[0, 0], [2, 0], [2, 2]], )" + members + "}]}");
    };
    EXPECT_EQ(with(R"("knots": [0, 1], "multiplicities": [3, 2])"),
              "the curve at /curves/0 was left out: the multiplicities add up to 5, but there must be 6 knots: points "
              "+ degree + 1, or for a periodic curve, whose first knot counts once, points + 1");
    EXPECT_EQ(
        with(R"("knots": [0, 1], "multiplicities": [3])"),
        "the curve at /curves/0 was left out: the number of multiplicities is 1 and that of knots 2; each knot must "
        "have one");
    EXPECT_EQ(
        with(R"("knots": [0, 0, 1], "multiplicities": [3, 1, 3])"),
        "the curve at /curves/0 was left out: \"knots\" must increase; equal ones are counted in \"multiplicities\"");
    EXPECT_EQ(with(R"("knots": [0, 1], "multiplicities": [3, 1e9])"),
              "the curve at /curves/0 was left out: a multiplicity must be a whole number from 1 to 26");
    EXPECT_EQ(
        with(R"("knots": [0, 1], "periodic": true, "multiplicities": [1, 2])"),
        "the curve at /curves/0 was left out: the first and the last multiplicity of a periodic curve must be equal");
}

TEST(JsonDialects, CountCurvesThatAreLeftOutForOneReason) {
    const std::string line = R"({"degree": 1, "knots": [0, 1], "multiplicities": [2, 2], "knotvector": [0, 0, 1, 1],
        "points": [[0, 0, 5], [1, 0, 5]], "poles": [[0, 0, 5], [1, 0, 5]],
        "control_points": {"points": [[0, 0, 5], [1, 0, 5]]}})";
    const std::string list = R"([{"degree": 0}, )" + line + R"(, {"degree": 0}, "x", )" + line + "]";
    const auto expect_counted = [](const core::FileResult<Imported>& found, const std::string& place) {
        ASSERT_TRUE(found) << found.error().sentence();
        EXPECT_EQ(found->document.curves.size(), 2U);
        EXPECT_EQ(found->report.left_out,
                  (std::vector<std::string>{
                      "2 curves were left out, the first at " + place +
                          "/0: \"degree\" is 0, but it must be a whole number from 1 to 25",
                      "2 curves have heights other than 0, the first at " + place + "/1, which were let go",
                      "the curve at " + place + "/3 was left out: it is no object"}));
    };
    expect_counted(read_rhino(R"({"curves": )" + list + "}"), "/curves");
    expect_counted(read_opencascade(R"({"curves": )" + list + "}"), "/curves");
    expect_counted(read_nurbs_python(R"({"shape": {"data": )" + list + "}}"), "/shape/data");
    const std::string flat = R"({"degree": 1, "knots": [0, 0, 1, 1], "dimension": 3,
        "control_points": [0, 0, 5, 1, 0, 5]})";
    expect_counted(read_tinyspline(R"([{"degree": 0}, )" + flat + R"(, {"degree": 0}, "x", )" + flat + "]"), "");
}

TEST(JsonDialects, TellThatAListEndsAtANumber) {
    const std::string line = R"({"degree": 1, "knots": [0, 1], "points": [[0, 0], [1, 0]]})";
    for (const char* odd : {"7", "[1, 2]"}) {
        const auto found = read_rhino(R"({"curves": [)" + line + ", " + odd + ", " + line + "]}");
        ASSERT_TRUE(found) << found.error().sentence();
        EXPECT_EQ(found->document.curves.size(), 1U);
        EXPECT_EQ(
            found->report.left_out,
            std::vector<std::string>{
                "the entry at /curves/1 of the list of curves is no object; it and what follows it was left out"});
    }
}

TEST(JsonDialects, TellThatAListBeginsWithANumber) {
    const std::string line = R"({"degree": 1, "knots": [0, 1], "points": [[0, 0], [1, 0]]})";
    for (const std::string& list : {"[3, " + line + "]", "[[1, 2], " + line + "]", std::string("[1, 2]")}) {
        const std::string end = " of the list of curves is no object; it and what follows it was left out";
        EXPECT_EQ(refusal_by(read_rhino, list), "the entry at /0" + end);
        EXPECT_EQ(refusal_by(read_rhino, R"({"curves": )" + list + "}"), "the entry at /curves/0" + end);
    }
}

TEST(JsonDialects, SayWhatIsWrongAndWhere) {
    EXPECT_EQ(refusal_by(read_rhino, "{\"curves\": [\n  nan]}"), "line 2, column 4: this is not JSON: invalid literal");
    EXPECT_EQ(refusal_by(read_rhino, "[1e999]"), "line 1, column 6: the number is too large; numbers must be finite");
    EXPECT_EQ(refusal_by(read_rhino, "[]"), "there are no curves in this file");
    EXPECT_EQ(refusal_by(read_rhino, "3"), "the curve at the top was left out: it is no object");
    EXPECT_EQ(refusal_by(read_rhino, R"({"degree": 2})"),
              "the curve at the top was left out: the member \"knots\" is missing");
    EXPECT_EQ(refusal_by(read_rhino, R"({"degree": 2.5})"),
              "the curve at the top was left out: \"degree\" is 2.5, but it must be a whole number from 1 to 25");
    EXPECT_EQ(refusal_by(read_rhino, R"({"degree": 2, "knots": [1, "a"]})"),
              "the curve at the top was left out: \"knots\" must be a list of numbers");
    EXPECT_EQ(
        refusal_by(read_rhino, R"({"degree": 2, "knots": [1], "points": [[1, 2], [1, 2, 3]]})"),
        "the curve at the top was left out: \"points\" must be a list of points, each a list of two or three numbers");
    EXPECT_EQ(refusal_by(read_rhino, R"({"degree": 2, "degree": 3})"),
              "line 1, column 22: the member \"degree\" occurs twice in one object; every name may occur once");
    EXPECT_EQ(refusal_by(read_nurbs_python, "{}"),
              "the member \"shape\" with \"data\" is missing, which every file of NURBS-Python has");
    EXPECT_EQ(refusal_by(read_rhino, "{\"a\":\n" + std::string(100'000, '[')),
              "line 2, column 100: lists and objects are nested more than 100 deep, the most that is read");
    EXPECT_EQ(refusal_by(read_rhino, std::string("[1, \0 2]", 8)),
              "line 1, column 5: this is not JSON: there is a zero byte, which no text has");
}

TEST(JsonTree, KeepsNumbersAndRowsTogether) {
    const auto tree =
        parse_json_tree(R"({"a": [1, 2, 3], "b": [[1, 2], [3, 4]], "c": [1, [2]], "d": [{}, 5], "e": []})");
    ASSERT_TRUE(tree) << tree.error().sentence();
    EXPECT_EQ(tree->member("a")->list()->numbers, (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(tree->member("b")->list()->row_length, 2U);
    EXPECT_EQ(tree->member("b")->list()->numbers, (std::vector<double>{1, 2, 3, 4}));
    EXPECT_EQ(tree->member("c")->list()->first_odd, 1U);
    EXPECT_EQ(tree->member("d")->list()->items.size(), 1U);
    EXPECT_EQ(tree->member("d")->list()->first_odd, 1U);
    EXPECT_TRUE(tree->member("e")->list()->numbers.empty());
    EXPECT_EQ(tree->member("f"), nullptr);
}

TEST(JsonTree, RefusesNamesThatOccurTwiceAmongFewAndMany) {
    for (const int members : {2, 16, 17, 18, 400}) {
        for (const int twice : {0, (members - 1) / 2, members - 2}) {
            std::string text = "{\"outer\":{";
            for (int i = 0; i < members - 1; ++i) text += "\"m" + std::to_string(i) + "\":{\"m0\":1},";
            text += "\"m" + std::to_string(twice) + "\":2}}";
            const auto tree = parse_json_tree(text);
            ASSERT_FALSE(tree);
            EXPECT_EQ(tree.error().what, "the member \"m" + std::to_string(twice) +
                                             "\" occurs twice in one object; every name may occur once");
        }
    }
}

// As many members, in objects of 10 and of 1000.
TEST(JsonTree, ManyMembersOfOneObjectTakeNoLonger) {
    EXPECT_LT(seconds_of_objects(30, 1000), 3.0 * seconds_of_objects(3000, 10));
}

}  // namespace batten::exchange
